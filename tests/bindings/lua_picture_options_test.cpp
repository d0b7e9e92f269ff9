// Pictures of scripts: where they are read, what goes wrong, and that a state and what is saved by hand has them.
#include "lua/thing/picture_options.hpp"

#include <filesystem>

#include "bindings/lua_support.hpp"
#include "measure/measure.hpp"
#include "scene/picture_file.hpp"
#include "support/process.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using support::Folder;

namespace {

std::string crate() { return support::read_file(sources::folder() + "/assets/pictures/crate.png"); }

std::unique_ptr<Scene> open_in(const Folder& folder, const std::string& source) {
  return lua::open_scene_text(source, "scene.lua", folder.path, options());
}

std::string failure_in(const Folder& folder, const std::string& source) {
  try {
    open_in(folder, source);
  } catch (const Error& error) { return error.what(); }
  return "";
}

const Shape& first_shape(const Scene& scene) {
  const World& world = scene.world();
  return world.shapes[world.bodies[world.bodies.ids()[0]].shapes[0]];
}

/// A PNG's head that says it has so many pixels, and an end.
std::string png_of(int columns) {
  std::string content = crate();
  content[18] = static_cast<char>(columns / 256);
  content[19] = static_cast<char>(columns % 256);
  return content;
}

}  // namespace

TEST_CASE("picture options: a file of the scene's folder, or of assets/pictures, is read once and told once") {
  const Folder folder;
  support::write_file(folder / "mine.png", crate());
  SceneOptions o = options();
  std::vector<std::string> told;
  o.on_read = [&](const FileRead& file) { told.push_back(file.path); };
  const auto scene = lua::open_scene_text(
      "for i = 1, 3 do scene:box { size = 1, at = vec(2 * i, 0, 0), picture = 'mine.png' } end\n"
      "scene:box { size = 1, picture = { file = 'bricks.png', width = 0.5 } }",
      "scene.lua", folder.path, o);
  CHECK(told == std::vector<std::string>{folder / "mine.png", sources::folder() + "/assets/pictures/bricks.png"});
  const World& world = scene->world();
  const auto& picture = world.shapes.at_slot(0).cover->picture;
  CHECK(picture->content == crate());
  CHECK(picture->columns == 128);
  CHECK(world.shapes.at_slot(2).cover->picture == picture);
  CHECK(world.shapes.at_slot(3).cover->width == 0.5);
}

TEST_CASE("picture options: what cannot be read is told with its file, and what is allowed") {
  const Folder folder, elsewhere;
  support::write_file(folder / "text.png", "no picture");
  support::write_file(folder / "half.png", crate().substr(0, 5000));
  support::write_file(folder / "wide.png", png_of(5000));
  std::string damaged = crate();
  damaged[4000] = static_cast<char>(damaged[4000] ^ 1);
  support::write_file(folder / "damaged.png", damaged);
  support::write_file(folder / "none.png", png_of(0));
  support::write_file(folder / "huge.png", std::string(largest_picture_file + 1, ' '));
  support::write_file(elsewhere / "a.png", crate());
  std::filesystem::create_symlink(elsewhere / "a.png", folder / "link.png");
  const auto told = [&](const std::string& value) {
    return failure_in(folder, "scene:box { size = 1, picture = " + value + " }");
  };
  CHECK_THAT(told("'text.png'"), Contains("scene.lua:1: box: picture: 'text.png' is neither a PNG nor a JPEG"));
  CHECK_THAT(told("'half.png'"), Contains("'half.png' is not whole"));
  CHECK_THAT(told("'damaged.png'"),
             Contains("scene.lua:1: box: picture: 'damaged.png' is damaged: the checksum of its "));
  CHECK_THAT(failure_in(folder, "scene:box { size = 1, sprite = { file = 'damaged.png', width = 1 } }"),
             Contains("scene.lua:1: box: sprite: 'damaged.png' is damaged"));
  CHECK_THAT(told("'wide.png'"), Contains("'wide.png' has 5000 x 128 pixels; at most 4096 x 4096 are read"));
  CHECK_THAT(told("'none.png'"), Contains("'none.png' has 0 x 128 pixels"));
  CHECK_THAT(told("'huge.png'"), Contains("at most 4 are read, a quarter of --memory-limit"));
  CHECK_THAT(told("'link.png'"), Contains("'link.png' leads out of its folder"));
  CHECK_THAT(told("'../a.png'"), Contains("must be a file below the scene's folder or assets/pictures"));
  CHECK_THAT(told("'gone.png'"), Contains("there is no file") && Contains("gone.png"));
  CHECK_THAT(told("3"),
             Contains("box: picture must be a file, \"crate.png\", or a table { file, width }, got a number"));
  CHECK_THAT(told("{ width = 1 }"), Contains("needs a file"));
  CHECK_THAT(told("{ file = 'crate.png', width = 0 }"), Contains("width must be from"));
  CHECK_THAT(told("{ file = 'crate.png', low = vec(0, 0, 0) }"), Contains("takes low and high"));
  CHECK_THAT(told("{ file = 'crate.png', low = vec(0, 0, 0), high = vec(1, 0, 1) }"),
             Contains("low must be below high"));
  CHECK_THAT(
      failure_in(folder, "scene:floor { picture = { file = 'crate.png', low = vec(0, 0, 0), high = vec(1, 1, 1) } }"),
      Contains("a plane has none"));
  CHECK_THAT(told("{ file = 'crate.png', wide = 1 }"), Contains("unknown field 'wide'"));
  CHECK_THAT(failure_in(folder, "scene:box { size = 1, sprite = 'bird.png' }"), Contains("sprite: needs a width [m]"));
  CHECK_THAT(failure_in(folder, "scene:body { mass = 1, picture = 'crate.png' }"),
             Contains("picture is of its shapes, and it has none"));
}

TEST_CASE("picture options: the motion is the same to the bit with pictures and without") {
  const auto hash = [](const std::string& picture) {
    const auto scene = open("scene:floor { " + picture + " }\nscene:box { size = 1, at = vec(0, 2, 0), " + picture +
                            " }\nscene:ball { radius = 0.3, at = vec(0.2, 4, 0.1), " + picture + " }");
    for (int i = 0; i < 300; i++) scene->step();
    return state_hash(scene->world());
  };
  CHECK(hash("") == hash("picture = 'crate.png'"));
}

TEST_CASE("picture options: a state has its pictures, whatever has become of the files") {
  std::string state;
  {
    const Folder folder;
    support::write_file(folder / "mine.png", crate());
    const auto scene = open_in(folder, R"(
      scene:box { size = 1, picture = { file = 'mine.png', width = 0.5 }, sprite = { file = 'mine.png', width = 2 } }
      local kept = shape.ball { radius = 1, picture = 'mine.png' }
      scene:at(0.1, function() scene:body { shape = kept } scene:box { size = 1, at = vec(9, 0, 0), picture = 'mine.png' } end)
    )");
    scene->step();
    state = scene->state();
  }
  const auto again = lua::open_state(state, "state.pantin", options());
  const World& world = again->world();
  CHECK(first_shape(*again).cover->picture->content == crate());
  CHECK(first_shape(*again).cover->width == 0.5);
  CHECK(world.bodies[world.bodies.ids()[0]].sprite->picture == first_shape(*again).cover->picture);
  for (int i = 0; i < 40; i++) again->step();
  REQUIRE(world.bodies.size() == 3);
  for (const BodyId body : world.bodies.ids())
    CHECK(world.shapes[world.bodies[body].shapes[0]].cover->picture->content == crate());
}

TEST_CASE("picture options: pieces show what of the picture the whole showed there") {
  const auto scene = open(R"(
    local box = scene:box { size = 2, picture = 'crate.png', sprite = { file = 'bird.png', width = 1 } }
    scene:split(box, { through = vec(0.5, 0, 0), normal = vec(1, 0, 0) })
  )");
  const World& world = scene->world();
  REQUIRE(world.bodies.size() == 2);
  for (const BodyId body : world.bodies.ids()) {
    const Shape& shape = world.shapes[world.bodies[body].shapes[0]];
    REQUIRE(shape.cover);
    CHECK(norm(shape.at + shape.cover->low - vec(-1, -1, -1)) < 1e-12);
    CHECK(norm(shape.at + shape.cover->high - vec(1, 1, 1)) < 1e-12);
    CHECK_FALSE(world.bodies[body].sprite);
  }
}
