// The properties of the thing that was clicked, or is under the pointer; and to be edited.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cstdio>

#include "fields/property.hpp"
#include "player/panels/pane.hpp"

namespace pantin::player {
namespace {

struct Reading {
  const fields::Property* property;
  fields::Value value;  ///< plain, see fields::plain
};

/// Those of a living thing that are shown: no lists and tables, and none that it has not at present.
std::vector<Reading> read_properties(const World& world, const AnyId& thing) {
  std::vector<Reading> readings;
  for (const fields::Property* property : fields::properties(fields::type_of(world, thing))) {
    if (std::string_view(property->name) == "alive" || std::string_view(property->type).ends_with("[]")) continue;
    try {
      fields::Value value = fields::plain(property->read(world, thing));
      if (fields::is_plain(value)) readings.push_back({property, std::move(value)});
    } catch (const Error&) {}
  }
  return readings;
}

class InspectorPane : public Pane {
 public:
  void draw(Desk& desk) override {
    const World& world = desk.world();
    if (alive(world, desk.chosen))
      shown_ = desk.chosen;
    else if (!std::holds_alternative<std::monostate>(desk.hovered))
      shown_ = desk.hovered;
    if (!alive(world, shown_)) return ImGui::TextDisabled("click a thing of the scene");
    if (!(seen_ == desk.seen() && read_of_ == shown_)) read(desk);
    for (std::size_t i = 0; i < things_.size(); i++) {
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::CollapsingHeader(things_[i].label.c_str(), i == 0 ? ImGuiTreeNodeFlags_DefaultOpen : 0))
        draw_fields(desk, things_[i]);
      ImGui::PopID();
    }
  }
  void reset() override { shown_ = {}, edited_.clear(), seen_ = {}; }

 private:
  struct ThingRead {
    AnyId thing;
    std::string label;
    std::vector<Reading> properties;
    std::vector<std::string> links;  ///< (properties) what the things among them are called
  };

  void read(Desk& desk) {
    things_.clear();
    for (const AnyId& thing : related(desk.world())) {
      ThingRead read{thing, describe(desk.world(), thing), read_properties(desk.world(), thing), {}};
      for (const Reading& shown : read.properties) read.links.push_back(link_label(desk.world(), shown.value));
      things_.push_back(std::move(read));
    }
    seen_ = desk.seen();
    read_of_ = shown_;
  }

  static std::string link_label(const World& world, const fields::Value& value) {
    const auto* thing = std::get_if<AnyId>(&value);
    return thing ? describe(world, *thing) : std::string();
  }

  /// The thing itself, a body with its shapes; but of a point its body first, then its particle or hinge.
  std::vector<AnyId> related(const World& world) const {
    std::vector<AnyId> things;
    const auto add_body = [&](BodyId body) {
      things.emplace_back(body);
      const auto& shapes = world.bodies[body].shapes;
      things.insert(things.end(), shapes.begin(), shapes.end());
    };
    if (const auto* body = std::get_if<BodyId>(&shown_)) return add_body(*body), things;
    const auto* point = std::get_if<PointId>(&shown_);
    if (!point) return {shown_};
    const Point& row = world.points[*point];
    if (row.body) add_body(row.body);
    if (row.particle && (!row.body || world.particles[row.particle].is_hinge())) things.emplace_back(row.particle);
    things.push_back(shown_);
    return things;
  }

  void draw_fields(Desk& desk, ThingRead& read) {
    if (!ImGui::BeginTable("fields", 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("name");
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t i = 0; i < read.properties.size(); i++) {
      Reading& shown = read.properties[i];
      const fields::Property& property = *shown.property;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(property.name);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s%s%s", property.doc, *property.unit ? ", " : "", property.unit);
      ImGui::TableNextColumn();
      ImGui::PushID(property.name);
      ImGui::SetNextItemWidth(-1.0f);
      if (const auto* other = std::get_if<AnyId>(&shown.value))
        draw_link(desk, *other, read.links[i]);
      else if (property.write)
        edit(desk, read.thing, shown);
      else
        tell(shown);
      ImGui::PopID();
    }
    ImGui::EndTable();
  }

  static void draw_link(Desk& desk, const AnyId& thing, const std::string& label) {
    if (ImGui::SmallButton(label.c_str())) desk.chosen = thing;
  }

  static void tell(const Reading& shown) {
    const char* unit = shown.property->unit;
    if (const auto* number = std::get_if<double>(&shown.value))
      ImGui::TextDisabled("%.6g %s", *number, unit);
    else if (const auto* boolean = std::get_if<bool>(&shown.value))
      ImGui::TextDisabled("%s", *boolean ? "true" : "false");
    else if (const auto* words = std::get_if<std::string>(&shown.value))
      ImGui::TextDisabled("%s", words->c_str());
    else if (const auto* vector = std::get_if<Vec3>(&shown.value))
      ImGui::TextDisabled("%.4g, %.4g, %.4g %s", (*vector)[0], (*vector)[1], (*vector)[2], unit);
    else
      ImGui::TextDisabled("–");
  }

  // While a property is being written, its value is here; it is the thing's when that is done.
  void edit(Desk& desk, const AnyId& thing, Reading& shown) {
    const char* name = shown.property->name;
    const bool is_edited = edited_ == name && edited_of_ == thing;
    fields::Value& value = is_edited ? draft_ : shown.value;
    bool changed = false;
    if (auto* number = std::get_if<double>(&value)) {
      changed = ImGui::InputDouble("##number", number, 0.0, 0.0, "%.6g");
    } else if (auto* boolean = std::get_if<bool>(&value)) {
      if (ImGui::Checkbox("##box", boolean)) desk.wishes.edit = FieldEdit{thing, name, value};
      return;
    } else if (auto* words = std::get_if<std::string>(&value)) {
      changed = ImGui::InputText("##words", words);
    } else if (auto* vector = std::get_if<Vec3>(&value)) {
      double xyz[3] = {(*vector)[0], (*vector)[1], (*vector)[2]};
      changed = ImGui::InputScalarN("##vec", ImGuiDataType_Double, xyz, 3, nullptr, nullptr, "%.3g",
                                    ImGuiInputTextFlags_CharsScientific);
      *vector = vec(xyz[0], xyz[1], xyz[2]);
    } else {
      return tell(shown);
    }
    if (changed) {
      edited_ = name;
      edited_of_ = thing;
      if (!is_edited) draft_ = value;
    }
    if (edited_ != name || !(edited_of_ == thing)) return;
    if (ImGui::IsItemDeactivatedAfterEdit()) desk.wishes.edit = FieldEdit{thing, name, value};
    if (!ImGui::IsItemActive()) {
      edited_.clear();
      seen_ = {};
    }
  }

  AnyId shown_, read_of_;
  SeenState seen_;
  std::vector<ThingRead> things_;
  std::string edited_;  ///< name of the property that is being written, of
  AnyId edited_of_;
  fields::Value draft_;
};

}  // namespace

std::unique_ptr<Pane> make_inspector_pane() { return std::make_unique<InspectorPane>(); }

}  // namespace pantin::player
