-- What a field returns as a copy cannot be written into, and is otherwise a table as others are.
local things = [[
  local a, b = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
  local dust = scene:family("dust", { attributes = { charge = 1, spin = 2 } })
]]

local wrong = {
  ["scene:rod(a, b, { breaks_at = { force = 3 } }).breaks_at.force = 2"] = "rod: breaks_at is a copy: give the whole, x.breaks_at = { force = 2 }",
  ["scene:rod(a, b).breaks_at.force = 2"] = "rod: breaks_at is a copy: give the whole, x.breaks_at = { force = 2 }",
  ["scene:connect(a, b, force.damper { damping = 1 }).breaks_at.length = 2"] = "connection: breaks_at is a copy: give the whole, x.breaks_at = { length = 2 }",
  ["a.breaks_at.torque = 2"] = "breaks_at is a copy: give the whole, x.breaks_at = { torque = 2 }",
  ["dust.attributes.charge = 3"] = "family: attributes can be read, not written",
  ["scene:emitter { rate = 1, lifetime = { min = 1, max = 2 } }.lifetime.min = 2"] = "emitter: lifetime is a copy: give the whole, x.lifetime = { min = 2 }",
  ["scene:emitter { rate = 1, at = { vec(0, 0, 0), vec(1, 1, 1) } }.at[1] = vec(2, 0, 0)"] = "emitter: at is a copy: give the whole, x.at = { … }",
  ["scene:box { size = 1, picture = { file = 'crate.png', width = 1 } }.picture.width = 2"] = "body: picture is a copy: give the whole, x.picture = { width = 2 }",
  ["scene:box { size = 1, sprite = { file = 'crate.png', width = 1 } }.sprite.width = 2"] = "body: sprite is a copy: give the whole, x.sprite = { width = 2 }",
  ["scene:on_path(a, { vec(0, 0, 0), vec(3, 0, 0) }).path[1] = vec(1, 0, 0)"] = "on_path: path can be read, not written",
  ["scene:string({ a, vec(0, 1, 0), b }).points[2] = vec(1, 0, 0)"] = "string: points can be read, not written",
  ["scene:connect(a, b, force.damper { damping = 1 }).particles[1] = b"] = "connection: particles can be read, not written",
  ["table.insert(scene:on_path(a, { vec(0, 0, 0), vec(3, 0, 0) }).path, vec(1, 0, 0))"] = "on_path: path can be read, not written",
}

for code, message in pairs(wrong) do
  test("a copy is not written into: " .. code, function()
    expect(function() open_text(things .. code) end):fails("text.lua:3: ")
    expect(function() open_text(things .. code) end):fails(message)
  end)
end

test("a copy is read, gone through, handed over and kept as any table", function()
  local opened = open_text(things .. [[
    local rod = scene:rod(a, b, { breaks_at = { force = 3, length = 4 } })
    local limits, told = rod.breaks_at, ""
    for k, v in pairs(limits) do told = told .. k .. v .. " " end
    assert(told == "force3.0 length4.0 ", told)
    assert(next(limits) == "force" and next(limits, "force") == "length" and next(limits, "length") == nil)
    assert(type(limits) == "table" and limits == limits and tostring(limits):find "table" and limits.torque == nil)
    rod.breaks_at = { force = 5 }
    assert(limits.force == 3 and rod.breaks_at.force == 5 and next(scene:rod(a, vec(0, 3, 0)).breaks_at) == nil)
    rod.breaks_at = limits
    assert(rod.breaks_at.length == 4)
    assert(scene:rod(b, vec(0, 3, 0), { breaks_at = limits }).breaks_at.force == 3)
    assert(scene:family("more", { attributes = dust.attributes }).attributes.spin == 2)

    local path = scene:on_path(a, { vec(0, 0, 0), vec(3, 0, 0), vec(3, 3, 0) }).path
    assert(#path == 3 and path[2] == vec(3, 0, 0) and path[4] == nil and select("#", table.unpack(path)) == 3)
    local count = 0
    for i, place in ipairs(path) do count = count + i * place.x end
    assert(count == 15)
    assert(#scene:on_path(b, path).path == 3)
    local sum = vec(0, 0, 0)
    for _, place in pairs(path) do sum = sum + place end
    assert(sum == vec(6, 3, 0))

    local source = scene:emitter { rate = 1, lifetime = { min = 1, max = 2 } }
    assert(scene:emitter { rate = 2, lifetime = source.lifetime }.lifetime.max == 2)
    local crate = scene:box { size = 1, picture = { file = "crate.png", width = 1 } }
    crate.picture = crate.picture
    assert(scene:box { size = 1, at = vec(5, 0, 0), picture = crate.picture }.picture.width == 1)

    scene.store.limits = limits
    crate.data.limits = limits
    local kept, gone_back
    scene:at(0.1, function() kept = scene:snapshot() end)
    scene:at(0.2, function()
      if gone_back then return end
      gone_back = true
      scene.store.limits = nil
      scene:restore(kept)
    end)
    scene:probe("limit", function() return scene.store.limits and scene.store.limits.force + crate.data.limits.length or 0 end)
  ]])
  opened:advance(0.15)
  expect(opened:read "limit"):equal(7)
  opened:advance(0.1)
  expect(opened:read "limit"):equal(7)
end)
