// Properties, read and written without a script.
#include "fields/property.hpp"

#include <catch2/catch.hpp>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "edit/coupling_constraints.hpp"
#include "fields/color.hpp"
#include "laws/library.hpp"
#include "lua/thing/fields.hpp"
#include "model/path.hpp"
#include "support/cases.hpp"

using namespace pantin;
using fields::Value;

namespace {

constexpr double infinity_ = std::numeric_limits<double>::infinity();

std::shared_ptr<const Law> law_of(const char* name, const std::map<std::string, double>& parameters) {
  LawArguments arguments;
  arguments.numbers = parameters;
  return std::make_shared<const Law>(make_library_law(name, arguments).front());
}

/// A world with one of each kind of thing, far enough from each other.
class Zoo {
 public:
  World world;
  std::map<std::string, AnyId> things;  ///< by what is special about them, or the kind's name

  Zoo() {
    add_points();
    add_ties();
    add_turns();
    add_couplings();
    add_sets();
    things["Scene"] = {};
  }

  ParticleId particle() {
    ParticleDef def;
    def.at = vec(10.0 * count_++, 0, 0);
    return add_particle(world, def);
  }
  PointId point() { return world.particles[particle()].points[0]; }
  BodyId body() {
    BodyDef def;
    def.at = vec(10.0 * count_++, 0, 0);
    def.mass = 1.0;
    def.inertia = diagonal(vec(1, 1.2, 1.4));
    PointDef end;
    end.mass = 0.5;
    end.at = vec(0.5, 0, 0);
    def.points = {end};
    return add_body(world, def);
  }

 private:
  void add_points() {
    things["Point"] = point();
    things["Particle"] = particle();
    const BodyId a = body(), b = body();
    things["Body"] = body();
    BodyDef solid;
    solid.at = vec(0, 0, 90);
    solid.shapes.emplace_back();
    things["solid"] = add_body(world, solid);
    ShapeDef floor;
    floor.geometry = HalfSpaceShape{};
    things["Collider"] = add_shape(world, floor);
    set_position(world, b, world.motion_of(a).x);
    const PointId ends[] = {world.bodies[a].points[0], world.bodies[b].points[0]};
    things["hinge"] = add_hinge(world, ends);
  }
  void add_ties() {
    things["Nail"] = add_nail(world, point());
    things["Follow"] = add_follow(world, point(), {});
    things["Rod"] = add_rod(world, point(), point());
    things["rod to a position"] = add_rod(world, point(), vec(0, 5, 0));
    things["OnPlane"] = cases::add_on_plane(world, point());
    things["String"] = add_string(world, {{point()}, {{}, vec(0, 9, 0)}});
    const auto path = std::make_shared<const Path>(std::vector<Vec3>{vec(0, 0, 0), vec(900, 0, 0)}, false, false);
    things["OnPath"] = add_on_path(world, point(), path);
    things["Join"] = add_join(world, point(), point());
  }
  void add_turns() {
    things["Weld"] = add_weld(world, body(), body());
    things["Orient"] = add_orient(world, body());
    AlignDef align;
    align.axis_a = align.axis_b = vec(0, 1, 0);
    align.angle = 0.5;
    things["Align"] = add_align(world, body(), body(), align);
    MotorDef motor;
    motor.axis = vec(0, 0, 1);
    motor.speed = 1.0;
    things["Motor"] = add_motor(world, body(), {}, motor);
    std::swap(motor.speed, motor.angle);
    things["motor by angle"] = add_motor(world, body(), {}, motor);
    LimitDef limit;
    limit.max = 1.0;
    things["Limit"] = add_limit(world, body(), {}, vec(0, 0, 1), limit);
  }
  void add_couplings() {
    GearDef gear;
    gear.axis_a = vec(0, 0, 1);
    gear.ratio.value = -2.0;
    things["Gear"] = add_gear(world, body(), body(), gear);
    RackDef rack;
    rack.axis = vec(0, 0, 1);
    rack.along = vec(1, 0, 0);
    rack.radius.value = 0.5;
    things["Rack"] = add_rack(world, body(), point(), rack);
    things["Pulley"] = add_pulley(world, point(), {{}, vec(0, 5, 0)}, point(), {{}, vec(0, 6, 0)});
    ScrewDef screw;
    screw.axis = vec(1, 0, 0);
    screw.lead.value = 0.1;
    const PointId a = world.bodies[body()].points[0], b = world.bodies[body()].points[0];
    things["Screw"] = add_screw(world, a, b, screw);
    SliderDef slider;
    slider.axis = vec(1, 0, 0);
    slider.carrier = body();
    slider.max = 3.0;
    things["Slider"] = add_slider(world, world.bodies[body()].points[0], slider);
    slider.max = infinity_;
    slider.length = 0.5;
    things["slider by length"] = add_slider(world, point(), slider);
  }
  void add_sets() {
    FamilyDef family;
    family.name = "dust";
    family.attributes = {{"charge", 2.0}};
    family.solid.emplace();
    const FamilyId dust = add_family(world, family);
    things["Family"] = dust;
    const GroupId group = add_group(world, "all");
    add_to_group(world, group, things.at("Particle"));
    things["Group"] = group;
    ConnectionDef tie;
    tie.ends = {{particle()}, {{}, vec(0, 3, 0)}};
    things["Connection"] = add_connection(world, law_of("spring", {{"stiffness", 3.0}, {"length", 1.0}}), tie);
    things["Interaction"] = add_interaction(world, law_of("repel", {{"stiffness", 2.0}}), dust, dust);
    things["Field"] = add_field(world, law_of("drag", {{"linear", 0.1}}), dust);
    EmitterDef emitter;
    emitter.rate = 2.0;
    emitter.family = dust;
    things["Emitter"] = add_emitter(world, emitter);
  }

  int count_ = 0;
};

std::string shown(const char* form, double a) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, form, a + 0.0);
  return buffer;
}
std::string shown(double a) { return shown("%.9g ", std::fabs(a) < 1e-12 ? 0.0 : a); }
std::string shown(Vec3 v) { return shown(v[0]) + shown(v[1]) + shown(v[2]); }

/// A value as a text, to nine digits.
std::string shown(const Value& value) {
  if (const auto* v = std::get_if<double>(&value)) return shown(*v);
  if (const auto* v = std::get_if<std::int64_t>(&value)) return shown(static_cast<double>(*v));
  if (const auto* v = std::get_if<bool>(&value)) return *v ? "true" : "false";
  if (const auto* v = std::get_if<std::string>(&value)) return *v;
  if (const auto* v = std::get_if<Vec3>(&value)) return shown(*v);
  if (const auto* v = std::get_if<Quat>(&value)) return shown(v->w) + shown(v->x) + shown(v->y) + shown(v->z);
  if (const auto* v = std::get_if<Color>(&value)) return fields::text_of(*v);
  if (const auto* v = std::get_if<Mat3>(&value)) return shown((*v)[0]) + shown((*v)[1]) + shown((*v)[2]);
  if (const auto* v = std::get_if<Breaking>(&value)) return shown(v->force) + shown(v->torque) + shown(v->length);
  if (const auto* v = std::get_if<fields::Lifetimes>(&value)) return shown(v->shortest) + shown(v->longest);
  if (const auto* v = std::get_if<EmitterPosition>(&value)) return shown(v->at);
  if (const auto* v = std::get_if<AnyId>(&value)) return "thing " + std::to_string(v->index());
  return "kind of value " + std::to_string(value.index());
}

const fields::Type& type_named(const Zoo& zoo, const std::string& key) {
  return fields::type_of(zoo.world, zoo.things.at(key));
}

/// Whether a value is one of the kind that the annotations name.
bool is_of(const std::string& type, const Value& value) {
  const auto names = [&](const char* name) { return type == name || type.starts_with(std::string(name) + "|"); };
  if (type.ends_with("[]") && !names("vec"))
    return std::holds_alternative<fields::Things>(value) || std::holds_alternative<fields::Table>(value);
  if (type.ends_with('?') && std::holds_alternative<std::monostate>(value)) return true;
  if (names("number") || names("number?")) return std::holds_alternative<double>(value);
  if (names("integer")) return std::holds_alternative<std::int64_t>(value);
  if (names("boolean")) return std::holds_alternative<bool>(value);
  if (names("string") || names("string?") || names("Look")) return std::holds_alternative<std::string>(value);
  if (names("vec|Inertia")) return std::holds_alternative<Mat3>(value);
  if (names("vec") || names("vec?")) return std::holds_alternative<Vec3>(value);
  if (names("quat")) return std::holds_alternative<Quat>(value);
  if (names("color")) return std::holds_alternative<Color>(value);
  if (names("Breaking")) return std::holds_alternative<Breaking>(value);
  if (names("Point") || names("Particle") || names("Body") || names("Point?") || names("Body?") || names("Family?"))
    return std::holds_alternative<AnyId>(value);
  return std::holds_alternative<fields::Table>(value);
}

struct Sample {
  const char* thing;
  const char* name;
  Value value;
};

/// What may break a tie of that kind.
Breaking loads_of(std::string_view thing) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> kinds) {
    return std::find(kinds.begin(), kinds.end(), thing) != kinds.end();
  };
  const bool turns = is_one_of({"Orient", "Align", "Motor", "motor by angle", "Limit", "Gear"});
  const bool both = is_one_of({"Weld", "Rack", "Screw", "Slider", "slider by length"});
  return {turns ? infinity_ : 2.0, turns || both ? 3.0 : infinity_, turns ? infinity_ : 400.0};
}

std::vector<Sample> samples_of_things(const Zoo& zoo) {
  return {
      {"Point", "position", vec(1, 2, 3)},
      {"Point", "velocity", vec(1, 2, 3)},
      {"Point", "mass", 2.5},
      {"Point", "color", Color{1, 0, 0, 1}},
      {"Point", "radius", 0.25},
      {"Point", "name", "dot"},
      {"Particle", "position", vec(1, 2, 3)},
      {"Particle", "velocity", vec(1, 2, 3)},
      {"Particle", "mass", 2.5},
      {"Particle", "family", zoo.things.at("Family")},
      {"Particle", "lifetime", 7.0},
      {"Particle", "lifetime", infinity_},
      {"Particle", "color", Color{0, 1, 0, 0.2f}},
      {"Particle", "radius", 0.25},
      {"Particle", "look", "glow"},
      {"Particle", "name", "grain"},
      {"hinge", "breaks_at", Breaking{2.0, infinity_, infinity_}},
      {"hinge", "enabled", false},
      {"hinge", "collide", true},
      {"Body", "position", vec(1, 2, 3)},
      {"Body", "velocity", vec(1, 2, 3)},
      {"Body", "origin", vec(1, 2, 3)},
      {"Body", "orientation", Quat{0.8, 0.0, 0.6, 0.0}},
      {"Body", "spin", vec(1, 2, 3)},
      {"Body", "mass", 2.5},
      {"Body", "inertia", diagonal(vec(1.5, 2.0, 2.5))},
      {"Body", "color", Color{0, 0, 1, 1}},
      {"Body", "name", "block"},
      {"solid", "friction", 0.25},
      {"solid", "restitution", 0.75},
      {"solid", "color", Color{0, 0, 1, 1}},
      {"solid", "layer", "car"},
      {"Family", "friction", 0.25},
      {"Family", "restitution", 0.25},
      {"Family", "layer", "sand"},
      {"Collider", "friction", 0.25},
      {"Collider", "restitution", 0.75},
      {"Collider", "rolling", 0.01},
      {"Collider", "spinning", 0.02},
      {"Collider", "surface_velocity", vec(1, 2, 3)},
      {"Collider", "layer", "ice"},
      {"Collider", "sensor", true},
      {"Collider", "size", 3.0},
      {"Collider", "color", Color{0, 1, 0, 1}},
      {"Connection", "breaks_at", Breaking{2.0, infinity_, 4.0}},
      {"Emitter", "at", EmitterPosition{{}, vec(1, 2, 3), {}}},
      {"Emitter", "rate", 3.0},
      {"Emitter", "velocity", vec(1, 2, 3)},
      {"Emitter", "spread", 0.5},
      {"Emitter", "lifetime", fields::Lifetimes{1.0, 2.0}},
      {"Emitter", "max", 12.0},
      {"Emitter", "max", infinity_},
  };
}

std::vector<Sample> samples_of_constraints() {
  return {
      {"Nail", "at", vec(1, 2, 3)},
      {"Follow", "target", vec(1, 2, 3)},
      {"Follow", "max_force", 30.0},
      {"rod to a position", "at", vec(1, 2, 3)},
      {"Rod", "length", 4.0},
      {"Orient", "to", Quat{0.8, 0.0, 0.6, 0.0}},
      {"Align", "angle", 0.25},
      {"Motor", "speed", 2.5},
      {"motor by angle", "angle", 0.25},
      {"Gear", "ratio", -3.0},
      {"Rack", "radius", 0.25},
      {"Pulley", "ratio", 2.0},
      {"Pulley", "length", 40.0},
      {"Screw", "lead", -0.2},
      {"Slider", "min", -0.5},
      {"Slider", "max", 1.5},
      {"slider by length", "length", 0.25},
      {"Motor", "max_torque", 30.0},
      {"Limit", "min", -0.5},
      {"Limit", "max", 1.5},
      {"OnPlane", "through", vec(1, 2, 3)},
      {"OnPlane", "normal", vec(0, 0, 1)},
      {"String", "length", 4.0},
  };
}

std::vector<Sample> samples_of_scene() {
  return {
      {"Scene", "gravity", vec(0, 0, -1)}, {"Scene", "step", 0.01},           {"Scene", "accuracy", 0.001},
      {"Scene", "accuracy_per", "step"},   {"Scene", "accuracy", Value()},    {"Scene", "integrator", "implicit"},
      {"Scene", "contact", "fast"},        {"Scene", "energy_return", false}, {"Scene", "box", vec(900, 9, 9)},
      {"Scene", "box", Value()},           {"Scene", "tolerance", 1e-5},      {"Scene", "seed", 12.0},
      {"Scene", "boltzmann", 2.0},
  };
}

std::vector<Sample> all_samples(const Zoo& zoo) {
  std::vector<Sample> all;
  for (auto& some : {samples_of_things(zoo), samples_of_constraints(), samples_of_scene()})
    all.insert(all.end(), some.begin(), some.end());
  for (const auto& entry : zoo.things) {
    const fields::Type& type = type_named(zoo, entry.first);
    const auto has = [&](const char* name) {
      const auto of_it = [&](const Sample& s) {
        return s.name == std::string_view(name) && &type_named(zoo, s.thing) == &type;
      };
      return !fields::find(type, name) || std::any_of(all.begin(), all.end(), of_it);
    };
    if (!has("name")) all.push_back({entry.first.c_str(), "name", "new"});
    if (!has("enabled")) all.push_back({entry.first.c_str(), "enabled", false});
    if (!has("breaks_at")) all.push_back({entry.first.c_str(), "breaks_at", loads_of(entry.first)});
  }
  return all;
}

}  // namespace

TEST_CASE("every property of every kind of thing is read without a script, and is what its annotation says") {
  Zoo zoo;
  std::set<std::string> kinds;
  for (const auto& [key, thing] : zoo.things) {
    const fields::Type& type = type_named(zoo, key);
    kinds.insert(type.name);
    for (const fields::Property* property : fields::properties(type)) {
      CAPTURE(key, property->name, property->type);
      const Value value = property->read(zoo.world, thing);
      CAPTURE(shown(value));
      CHECK((is_of(property->type, value) || (std::string(property->type) == "Body[]" && value.index() == 0)));
    }
  }
  CHECK(kinds.size() == constraint_names.size() - 1 + 11);  // an axis is no thing of its own
}

TEST_CASE("what is written to a property is read from it, of every property that can be written") {
  Zoo zoo;
  std::set<const fields::Property*> written;
  for (const Sample& sample : all_samples(zoo)) {
    CAPTURE(sample.thing, sample.name, shown(sample.value));
    const AnyId thing = zoo.things.at(sample.thing);
    fields::write(zoo.world, thing, sample.name, sample.value);
    CHECK(shown(fields::read(zoo.world, thing, sample.name)) == shown(sample.value));
    written.insert(fields::find(type_named(zoo, sample.thing), sample.name));
  }
  World flat;
  fields::write(flat, {}, "plane", "xz");
  CHECK(std::get<std::string>(fields::read(flat, {}, "plane")) == "xz");
  written.insert(fields::find(fields::scene_type(), "plane"));
  for (const auto& [key, thing] : zoo.things)
    for (const fields::Property* property : fields::properties(type_named(zoo, key))) {
      CAPTURE(key, property->name);
      CHECK((written.contains(property) || !property->write));
    }
}

TEST_CASE("a property that is given a wrong value says its name, and stays") {
  Zoo zoo;
  for (const Sample& sample : all_samples(zoo)) {
    CAPTURE(sample.thing, sample.name);
    const AnyId thing = zoo.things.at(sample.thing);
    const auto& type = type_named(zoo, sample.thing);
    const fields::Property& property = *fields::find(type, sample.name);
    const std::string before = shown(property.read(zoo.world, thing));
    const std::string word = property.word ? property.word : type.word;
    const auto names_it = Catch::StartsWith(word + ": " + sample.name + " must be ");
    CHECK_THROWS_WITH(fields::write(zoo.world, thing, sample.name, fields::Things{}), names_it);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(fields::write(zoo.world, thing, sample.name, nan), names_it);
    CHECK_THROWS_WITH(fields::write(zoo.world, thing, sample.name, vec(nan, 0, 0)), names_it);
    CHECK(shown(property.read(zoo.world, thing)) == before);
  }
  CHECK_THROWS_WITH(fields::write(zoo.world, zoo.things.at("Body"), "momentum", vec(0, 0, 0)),
                    "body: momentum can be read, not written");
  CHECK_THROWS_WITH(fields::read(zoo.world, zoo.things.at("Body"), "weight"), "body: there is no property 'weight'");
  CHECK_THROWS_WITH(fields::write(zoo.world, zoo.things.at("Body"), "mass", 0.25),
                    Catch::StartsWith("body: mass must be at least that of its points, 0.5 kg"));
}

TEST_CASE("a property is written as a person reads it") {
  Zoo zoo;
  const AnyId body = zoo.things.at("Body"), emitter = zoo.things.at("Emitter");
  fields::write(zoo.world, body, "color", "#ff8000");
  CHECK(std::get<std::string>(fields::plain(fields::read(zoo.world, body, "color"))) == "#ff8000");
  fields::write(zoo.world, body, "inertia", vec(2, 3, 4));
  CHECK(shown(fields::plain(fields::read(zoo.world, body, "inertia"))) == shown(vec(2, 3, 4)));
  fields::write(zoo.world, emitter, "lifetime", 3.0);
  CHECK(shown(fields::read(zoo.world, emitter, "lifetime")) == shown(3.0));
  fields::write(zoo.world, emitter, "at", vec(1, 2, 3));
  CHECK(shown(fields::read(zoo.world, emitter, "at")) == shown(vec(1, 2, 3)));
}

TEST_CASE("a property that follows a function of time is read as what it is now") {
  Zoo zoo;
  const AnyId rod = zoo.things.at("Rod");
  zoo.world.time = 2.0;
  fields::write(zoo.world, rod, "length", fields::NumberOfTime([](double t) { return 3.0 + t; }));
  CHECK(std::get<double>(fields::read(zoo.world, rod, "length")) == 5.0);
}

TEST_CASE("the types of Lua have the properties of bindings/fields, in their order") {
  const Zoo zoo;
  std::map<std::string, const lua::Type*> types;
  for (const auto& list : {lua::all_types(), lua::base_types()})
    for (const lua::Type* type : list) types[type->name] = type;
  std::set<const fields::Type*> known;
  for (const auto& entry : zoo.things)
    for (const auto* type = &type_named(zoo, entry.first); type; type = type->base) known.insert(type);
  for (const fields::Type* type : known) {
    CAPTURE(type->name);
    REQUIRE(types.contains(type->name));
    const lua::Type& in_lua = *types.at(type->name);
    CHECK(in_lua.word == std::string(type->word));
    CHECK((in_lua.base ? in_lua.base->name : "") == std::string(type->base ? type->base->name : ""));
    std::vector<const fields::Property*> there;
    for (const lua::Field& field : in_lua.fields)
      if (field.property) there.push_back(field.property);
    std::vector<const fields::Property*> wanted;
    for (const fields::Property* property : fields::properties(*type)) wanted.push_back(property);
    wanted.resize(std::min(wanted.size(), there.size()));
    CHECK(there.size() >= type->properties.size());
    CHECK(there == wanted);
  }
}
