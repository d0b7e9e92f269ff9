#include "bindings/lua_law_support.hpp"
#include "lua/scene/script_scene.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

namespace {

const double distances[] = {0.3, 0.7, 1.0, 1.3, 2.2};

/// Force over distance and energy of a law, traced and called, must be those of a formula within 1e-12 of `size`.
void check_potential(const std::string& body, double (*energy)(double r), double (*slope)(double r),
                     const std::string& options = "") {
  CAPTURE(body, options);
  const auto traced = resolve("law = force.pair { strict = true, " + options + " potential = function(r, a, b, own) " +
                              body + " end }");
  REQUIRE(traced.law().has_energy());
  for (double r : distances) {
    CAPTURE(r);
    for (const Law* law : {&traced.law(), &traced.called()}) {
      const auto values = outputs_of(*law, pair(r, 2.0, -3.0));
      const double size = 1.0 + std::fabs(energy(r)) + std::fabs(slope(r));
      CHECK(std::fabs(values[0] * r - slope(r)) < 1e-12 * size);
      CHECK(std::fabs(values[1] - energy(r)) < 1e-12 * size);
    }
  }
}

}  // namespace

TEST_CASE("a potential becomes an expression, and its force the derivative") {
  check_potential(
      "return 4 * (r^-12 - r^-6)", [](double r) { return 4 * (std::pow(r, -12) - std::pow(r, -6)); },
      [](double r) { return 4 * (-12 * std::pow(r, -13) + 6 * std::pow(r, -7)); });
  check_potential(
      "local s = 1 / r return 4 * (s^12 - s^6)", [](double r) { return 4 * (std::pow(r, -12) - std::pow(r, -6)); },
      [](double r) { return 4 * (-12 * std::pow(r, -13) + 6 * std::pow(r, -7)); });
  check_potential(
      "return 0.5 * own.k * (r - own.rest)^2", [](double r) { return 20 * (r - 0.8) * (r - 0.8); },
      [](double r) { return 40 * (r - 0.8); }, "parameters = { k = 40, rest = 0.8 },");
  check_potential(
      "return a.charge * b.charge / r", [](double r) { return -6 / r; }, [](double r) { return 6 / (r * r); });
}

TEST_CASE("functions of math are traced") {
  check_potential(
      "return math.exp(-2 * r) * math.cos(3 * r)", [](double r) { return std::exp(-2 * r) * std::cos(3 * r); },
      [](double r) { return std::exp(-2 * r) * (-2 * std::cos(3 * r) - 3 * std::sin(3 * r)); });
  check_potential(
      "return math.log(r) + math.sqrt(r) + math.sin(r)",
      [](double r) { return std::log(r) + std::sqrt(r) + std::sin(r); },
      [](double r) { return 1 / r + 0.5 / std::sqrt(r) + std::cos(r); });
  check_potential(
      "return math.tanh(r) + math.atan(r) + math.atan(r, 2) + math.tan(r / 2)",
      [](double r) { return std::tanh(r) + std::atan(r) + std::atan2(r, 2) + std::tan(r / 2); },
      [](double r) {
        return 1 - std::tanh(r) * std::tanh(r) + 1 / (1 + r * r) + 2 / (4 + r * r) + 0.5 / std::pow(std::cos(r / 2), 2);
      });
  check_potential(
      "return math.asin(r / 3) + math.acos(r / 4)", [](double r) { return std::asin(r / 3) + std::acos(r / 4); },
      [](double r) { return 1 / std::sqrt(9 - r * r) - 1 / std::sqrt(16 - r * r); });
  check_potential(
      "return math.min(r, 1.1) + math.max(r, 1.5) + math.abs(r - 1.2)",
      [](double r) { return std::fmin(r, 1.1) + std::fmax(r, 1.5) + std::fabs(r - 1.2); },
      [](double r) { return (r < 1.1 ? 1. : 0.) + (r > 1.5 ? 1. : 0.) + (r < 1.2 ? -1. : 1.); });
  check_potential(
      "return (r % 0.9) + math.fmod(r, 0.8) + r // 0.6 + math.floor(r * 1.7) + math.ceil(r * 2.3)",
      [](double r) {
        return std::fmod(r, 0.9) + std::fmod(r, 0.8) + std::floor(r / 0.6) + std::floor(r * 1.7) + std::ceil(r * 2.3);
      },
      [](double) { return 2.0; });
  check_potential(
      "return math.log(r, 10) + r^r + 2^r + math.pi - -r",
      [](double r) { return std::log10(r) + std::pow(r, r) + std::exp2(r) + M_PI + r; },
      [](double r) {
        return 1 / (r * std::log(10)) + std::pow(r, r) * (std::log(r) + 1) + std::exp2(r) * std::log(2) + 1;
      });
}

TEST_CASE("branches become a choice") {
  const auto energy = [](double r) { return r < 0.5 ? 1 - r : r < 1.2 ? r * r : 3 / r; };
  const auto slope = [](double r) { return r < 0.5 ? -1 : r < 1.2 ? 2 * r : -3 / (r * r); };
  check_potential("if r < 0.5 then return 1 - r elseif r < 1.2 then return r^2 end return 3 / r", energy, slope);
  check_potential("if r >= 1.2 then return 3 / r elseif not (r < 0.5) then return r^2 else return 1 - r end", energy,
                  slope);
  check_potential("return where(r < 0.5, 1 - r, where(1.2 > r, r^2, 3 / r))", energy, slope);
  check_potential("return r < 0.5 and 1 - r or r < 1.2 and r^2 or 3 / r", energy, slope);
  check_potential(
      "local x = 0 for i = 1, 3 do if r > i / 2 then x = x + i * r end end return x",
      [](double r) { return (r > 0.5 ? r : 0) + (r > 1 ? 2 * r : 0) + (r > 1.5 ? 3 * r : 0); },
      [](double r) { return (r > 0.5 ? 1. : 0.) + (r > 1 ? 2. : 0.) + (r > 1.5 ? 3. : 0.); });
}

TEST_CASE("a cutoff shifts the energy, not the force") {
  check_potential(
      "return 1 / r", [](double r) { return 1 / r - 0.4; }, [](double r) { return -1 / (r * r); }, "cutoff = 2.5,");
  check_potential(
      "return 1 / r", [](double r) { return 1 / r; }, [](double r) { return -1 / (r * r); },
      "cutoff = 2.5, shift = false,");
}

TEST_CASE("tensions use distance and its rate, forces vecs") {
  const auto spring =
      resolve("law = force.pair { strict = true, tension = function(r, rate) return 40 * (r - 1) + 0.3 * rate end }");
  Seen seen = pair(2.0);
  seen[input(Role::approach)] = 3.0;  // rate 1.5
  CHECK(outputs_of(spring.law(), seen)[0] == Approx((40 + 0.45) / 2).epsilon(1e-14));
  CHECK(outputs_of(spring.called(), seen)[0] == Approx((40 + 0.45) / 2).epsilon(1e-14));

  const auto force = resolve(R"(law = force.pair { strict = true, force = function(d, u, a, b, own, t)
    local n = d:normalized()
    return 0.4 * u + d:cross(vec(0, 0, 1)) / 2 - n * (u:dot(n)) + vec(t, d.x, 0) - vec(1, 0, 0) * d:length()
  end })");
  const Vec3 d = vec(1, 2, -2), u = vec(0.5, -1, 3), n = d / 3.0;
  seen = {{input(Role::time), 7.0}};
  for (int i = 0; i < 3; i++) {
    seen[input(Role::displacement, 0, i)] = d[i];
    seen[input(Role::relative_velocity, 0, i)] = u[i];
  }
  const Vec3 wanted = 0.4 * u + cross(d, vec(0, 0, 1)) / 2.0 - n * dot(u, n) + vec(7, 1, 0) - vec(3, 0, 0);
  for (const Law* law : {&force.law(), &force.called()}) {
    const auto got = outputs_of(*law, seen);
    for (std::size_t i = 0; i < 3; i++) CHECK(std::fabs(got[i] - wanted[static_cast<int>(i)]) < 1e-13);
  }
}

TEST_CASE("laws of single particles and of several see places") {
  const auto wave = resolve(
      "law = force.point { strict = true, potential = function(p) return p.mass * math.sin(p.position.x) * "
      "p.position.y end }");
  Seen seen = {{input(Role::attribute, 0, 0, "mass"), 2.0},
               {input(Role::position, 0, 0), 0.5},
               {input(Role::position, 0, 1), 3.0},
               {input(Role::position, 0, 2), 1.0}};
  for (const Law* law : {&wave.law(), &wave.called()}) {
    const auto got = outputs_of(*law, seen);
    CHECK(got[0] == Approx(-6 * std::cos(0.5)).epsilon(1e-14));
    CHECK(got[1] == Approx(-2 * std::sin(0.5)).epsilon(1e-14));
    CHECK(got[2] == 0.0);
    CHECK(got[3] == Approx(6 * std::sin(0.5)).epsilon(1e-14));
  }
  const auto angle = resolve(R"(law = force.many { count = 3, strict = true, potential = function(p)
    local u, v = p[1].position - p[2].position, p[3].position - p[2].position
    return math.acos(u:dot(v) / (u:length() * v:length()))^2
  end })");
  seen.clear();
  const double places[3][3] = {{1, 0, 0}, {0, 0, 0}, {0, 2, 0}};
  for (int who = 0; who < 3; who++)
    for (int i = 0; i < 3; i++) seen[input(Role::position, who, i)] = places[who][i];
  for (const Law* law : {&angle.law(), &angle.called()}) {
    const auto got = outputs_of(*law, seen);
    CHECK(got[1] == Approx(M_PI));  // of the first: towards the third, π / 1
    CHECK(got[6] == Approx(M_PI / 2));
    CHECK(got[9] == Approx(M_PI * M_PI / 4));
    CHECK(std::fabs(got[0] + got[3] + got[6]) < 1e-14);
  }
}

TEST_CASE("numbers of the scene are baked in, parameters are not") {
  const auto law = resolve(
      "local strength = 3 law = force.pair { strict = true, parameters = { range = 2 },"
      "tension = function(r, rate, a, b, own) return strength * own.range * r end } strength = 5");
  CHECK(outputs_of(law.law(), pair(1))[0] == Approx(10).epsilon(1e-15));
  Seen seen = pair(1);
  seen[input(Role::parameter, 0, 0, "range")] = 7.0;
  CHECK(outputs_of(law.law(), seen)[0] == Approx(35).epsilon(1e-15));
  CHECK(law.resolved.values == std::vector<double>{2.0});
  REQUIRE(law.law().parameters.size() == 1);
  CHECK(law.law().parameters[0].name == "range");
}

TEST_CASE("noise is counted in the order of its calls") {
  const auto law =
      resolve("law = force.pair { strict = true, tension = function(r) return noise() * r + 10 * noise() end }");
  Seen seen = pair(2);
  seen[input(Role::noise, 0, 0)] = 3.0;
  seen[input(Role::noise, 0, 1)] = 0.5;
  CHECK(outputs_of(law.law(), seen)[0] == Approx(11 / 2.0).epsilon(1e-15));
  CHECK(outputs_of(law.called(), seen)[0] == Approx(11 / 2.0).epsilon(1e-15));
  CHECK_FALSE(law.law().has_energy());
  CHECK_THAT(failure("noise()"), Contains("scene.lua:1: noise: may be called only inside the function of a law"));
}

TEST_CASE("laws as people write them are traced") {
  const std::string laws[] = {
      "cutoff = 2.5, potential = function(r, a, b) local s = (a.radius + b.radius) / r return 4.8 * (s^12 - s^6) end",
      "cutoff = 1.2, tension = function(r, rate) return -500 * (1.2 - r)^1.5 + 2 * rate * (1.2 - r)^0.5 end",
      "cutoff = 3, potential = function(r, a, b) return 138.9 * a.charge * b.charge * math.exp(-r / 0.7) / r end",
      "cutoff = 3, potential = function(r) local x = (r - 2) / 1 if x < 0 then return 1 / r end local y = 1 - x return "
      "y * y * y * (6 * x * x + 3 * x + 1) / r end",
      "potential = function(r) local x = math.max(0, math.min(1, (r - 1) / 2)) return 7 * x * x * (3 - 2 * x) end",
      "potential = function(r) return 1.5 * (1 - math.exp(-2 * (r - 1.1)))^2 - 1.5 end",
      "potential = function(r) return -7.5 * math.log(1 - (math.min(r, 1.49) / 1.5)^2) end",
      "tension = function(r, rate, a, b, own, t) return 3 * math.sin(2 * math.pi * t) * (r - 1) / (1 + r * r) end",
      "tension = function(r, rate, a, b) return -6.7e-11 * a.mass * b.mass / (r * r + 1e-4)^1.5 * r end",
      "tension = function(r) local m = 0 for k = 1, 20 do m = m + math.cos(k * r) / k^2 end return m end",
      "cutoff = 1e-9, potential = function(r) return 1.6e-21 * ((3.4e-10 / r)^12 - (3.4e-10 / r)^6) end",
      "force = function(d, u, a, b) local r = d:length() local n = d / r return n * (40 * (r - 1)) + n * u:dot(n) * "
      "0.3 end",
      "force = function(d, u) if d:dot(d) > 9 then return vec(0, 0, 0) end return 0.1 * d:normalized() + 0.4 * u end",
      "force = function(d, u, a, b, own, t) return d * (a.charge * b.charge * math.cos(t)) end",
  };
  for (const std::string& law : laws) {
    CAPTURE(law);
    CHECK(refusal("law = force.pair { strict = true, " + law + " }", true) == "");
  }
  const std::string fields[] = {
      "potential = function(p) return 0.5 * p.mass * 9.81 * p.position:length() end",
      "force = function(p, own, t) return vec(math.sin(t), 0, 0) - 0.1 * p.velocity end",
      "force = function(p) local v = p.velocity return -0.5 * v:length() * v end",
      "force = function(p) if p.position.y > 0 then return vec(0, 0, 0) end return vec(0, -1e4 * p.position.y, 0) end",
      "force = function(p) return p.charge * (vec(0, 1, 0) + p.velocity:cross(vec(0, 0, 2))) end",
      "force = function(p) return vec(noise(), noise(), noise()) * math.sqrt(p.mass) - p.velocity * 2 end",
  };
  for (const std::string& law : fields) {
    CAPTURE(law);
    CHECK(refusal("law = force.point { strict = true, " + law + " }") == "");
  }
}

TEST_CASE("what cannot be traced is told, with the line") {
  const auto reason = [](const std::string& body) {
    return refusal("law = force.pair { strict = true, tension = function(r, rate, a, b, own, t)\n" + body + "\nend }");
  };
  CHECK_THAT(reason("return r == 1 and 2 or 3"),
             Contains("strict = true, and the law cannot be traced: scene.lua:2: == or ~="));
  CHECK_THAT(reason("local n = 0 while r > n do n = n + 1 end return n"),
             Contains("scene.lua:2: more than 12 branches"));
  CHECK_THAT(reason("local n = 0 for i = 1, math.floor(math.min(r, 9)) do n = n + i end return n"),
             Contains("scene.lua:2: bad 'for' limit (number expected"));
  CHECK_THAT(reason("return #tostring(r)"), Contains("scene.lua:2: a text is made of a value"));
  CHECK_THAT(reason("return #('x' .. r)"), Contains("scene.lua:2: a text is made of a value"));
  CHECK_THAT(reason("return ({ 1, 2, 3 })[math.floor(r) % 3 + 1]"), Contains("it returns nil on one of its branches"));
  CHECK_THAT(reason("return ({ 1, 2, 3 })[math.floor(r) % 3 + 1] or 0"),
             Contains("scene.lua:1: traced, the force is 0 and called it is "));
  CHECK_THAT(reason("return math.tointeger(math.floor(math.min(r, 9))) * 1.0"),
             Contains("scene.lua:2: the kind or the digits of a value"));
  CHECK_THAT(reason("return scene.step * r"), Contains("scene.lua:2: it reads step of a thing"));
  CHECK_THAT(reason("local x = 0 for i = 1, 7 do if r < i and a.charge < i then x = x + 1 end end return x"),
             Contains("more than"));
  // Texts that are equal or not are no concern of numbers; nor are tests that are allowed.
  CHECK(reason("local kind = 'soft' if kind == 'soft' then return r end return 2 * r") == "");
  CHECK(reason("if own == nil then return r end return 2 * r") == "");
  CHECK(refusal("law = force.pair { exact = false, strict = true, tension = function(r) return r == 1.234 and 2 or r "
                "end }") == "");
  CHECK(refusal("law = force.pair { exact = false, strict = true, tension = function(r, rate, a, b) return a.charge == "
                "b.mass * 17.3 and 2 or r end }") == "");
  // In what the law calls, too.
  CHECK_THAT(refusal("local function f(r)\n return r ~= 1 and r or 2 end\nlaw = force.pair { strict = true, tension = "
                     "function(r) return f(r) end }"),
             Contains("scene.lua:2: == or ~="));
}

TEST_CASE("mistakes in a law are errors, however it is run") {
  const auto message = [](const std::string& body) {
    return refusal("law = force.pair { parameters = { range = 1 }, potential = function(r, a, b, own, t)\n" + body +
                   "\nend }");
  };
  CHECK(message("return a.chrage * r") ==
        "scene.lua:2: family 'ion' has no attribute 'chrage'. Did you mean 'charge'? It "
        "has mass, radius, age, lifetime, charge");
  CHECK(message("return own.rang * r") ==
        "scene.lua:2: the law has no parameter 'rang'. Did you mean 'range'? It has range");
  CHECK_THAT(message("return math.random() * r"), Contains("scene.lua:2: math.random is not for laws"));
  CHECK_THAT(message("return os.time() * r"), Contains("scene.lua:2: attempt to index a nil value (global 'os')"));
  CHECK_THAT(message("return a.position.x"),
             Contains("scene.lua:2: a law of the distance sees no position; give force"));
  CHECK_THAT(message("scene.pace = 2 return r"),
             Contains("scene.lua:2: a law reads numbers and returns; it cannot write to a scene"));
  CHECK_THAT(message("scene:particle() return r"),
             Contains("scene.lua:2: a law reads numbers and returns; it cannot call scene:particle"));
  CHECK_THAT(message("own.range = 2 return r"), Contains("scene.lua:2: a law reads its arguments and returns"));
  CHECK_THAT(message("return vec(r, 0, 0)"), Contains("the law must return a number [J], got a vec"));
  CHECK_THAT(message("local x = r"), Contains("scene.lua:1: the law must return a number [J], got nil"));
  CHECK_THAT(message("return r + nothing"), Contains("scene.lua:2: ") && Contains("got nil"));
  CHECK_THAT(refusal("law = force.point { potential = function(p)\n return p.velocity.x end }"),
             Contains("scene.lua:2: a potential cannot depend on velocity"));
  CHECK_THAT(refusal("law = force.many { count = 3, potential = function(p)\n return p.position.x end }"),
             Contains("scene.lua:2: the particles of this law are a list of 3"));
}

TEST_CASE("what was kept from inside of a law is of no use outside") {
  const auto scene = resolve("law = force.pair { tension = function(r, rate, a) kept_r, kept_a = r, a return r end }");
  lua::Script& script = lua::script_of(*scene.scene);
  const auto run = [&](const std::string& source) {
    try {
      script.runtime.run([&](lua_State* state) {
        script.runtime.load(state, source, "later.lua");
        lua_call(state, 0, 0);
      });
    } catch (const Error& error) { return std::string(error.what()); }
    return std::string();
  };
  CHECK_THAT(run("local x = kept_a.charge"), Contains("lives only while the law's function runs"));
}

TEST_CASE("within one family a law is the same with a and b exchanged") {
  const std::string lopsided = "tension = function(r, rate, a, b) return (a.charge - b.charge) * r end }";
  CHECK_THAT(refusal("law = force.pair { " + lopsided, true),
             Contains("scene.lua:1: within one family a law must be the same with a and b exchanged") &&
                 Contains("a.charge = "));
  CHECK(refusal("law = force.pair { one_sided = true, " + lopsided, true) == "");
  CHECK(refusal("law = force.pair { " + lopsided, false) == "");
  CHECK(refusal("law = force.pair { tension = function(r, rate, a, b) return (a.charge - b.charge)^2 * r end }",
                true) == "");
  CHECK(refusal("law = force.pair { force = function(d, u, a, b) return 0.4 * u + a.charge * b.charge * d end }",
                true) == "");
  CHECK_THAT(refusal("law = force.pair { force = function(d) return vec(d.x^2, 0, 0) end }", true),
             Contains("must be the same"));
}
