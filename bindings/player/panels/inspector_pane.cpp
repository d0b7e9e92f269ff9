// The fields of the thing that was clicked, or is under the pointer, as scripts see them; and to be edited.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cstdio>

#include "lua/scene/inspect.hpp"
#include "player/panels/pane.hpp"

namespace pantin::player {
namespace {

using lua::FieldReading;

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
    bool first = true;
    for (ThingRead& thing : things_) {
      ImGui::PushID(first ? "first" : "more");
      if (ImGui::CollapsingHeader(thing.label.c_str(), first ? ImGuiTreeNodeFlags_DefaultOpen : 0))
        draw_fields(desk, thing);
      ImGui::PopID();
      first = false;
    }
  }
  void reset() override { shown_ = {}, edited_.clear(), seen_ = {}; }

 private:
  struct ThingRead {
    AnyId thing;
    std::string label;
    std::vector<FieldReading> fields;
    std::vector<std::string> links;  ///< (fields) what the things among them are called
  };

  void read(Desk& desk) {
    things_.clear();
    for (const AnyId& thing : related(desk.world())) {
      ThingRead read{thing, describe(desk.world(), thing), lua::read_fields(desk.scene, thing), {}};
      for (const FieldReading& field : read.fields) read.links.push_back(link_label(desk.world(), field.thing));
      things_.push_back(std::move(read));
    }
    seen_ = desk.seen();
    read_of_ = shown_;
  }

  static std::string link_label(const World& world, const AnyId& thing) {
    return std::holds_alternative<std::monostate>(thing) ? std::string() : describe(world, thing);
  }

  /// The thing itself, but of a point its body first, then its particle or hinge.
  std::vector<AnyId> related(const World& world) const {
    const auto* point = std::get_if<PointId>(&shown_);
    if (!point) return {shown_};
    const Point& row = world.points[*point];
    std::vector<AnyId> things;
    if (row.body) things.emplace_back(row.body);
    if (row.particle && (!row.body || world.particles[row.particle].is_hinge())) things.emplace_back(row.particle);
    things.push_back(shown_);
    return things;
  }

  void draw_fields(Desk& desk, ThingRead& read) {
    if (!ImGui::BeginTable("fields", 2, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("name");
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t i = 0; i < read.fields.size(); i++) {
      FieldReading& field = read.fields[i];
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(field.name);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s%s%s", field.doc, *field.unit ? ", " : "", field.unit);
      ImGui::TableNextColumn();
      ImGui::PushID(field.name);
      ImGui::SetNextItemWidth(-1.0f);
      if (!std::holds_alternative<std::monostate>(field.thing))
        draw_link(desk, field.thing, read.links[i]);
      else if (field.writable)
        edit(desk, read.thing, field);
      else
        tell(field);
      ImGui::PopID();
    }
    ImGui::EndTable();
  }

  static void draw_link(Desk& desk, const AnyId& thing, const std::string& label) {
    if (ImGui::SmallButton(label.c_str())) desk.chosen = thing;
  }

  static void tell(const FieldReading& field) {
    if (const auto* number = std::get_if<double>(&field.value))
      ImGui::TextDisabled("%.6g %s", *number, field.unit);
    else if (const auto* boolean = std::get_if<bool>(&field.value))
      ImGui::TextDisabled("%s", *boolean ? "true" : "false");
    else if (const auto* words = std::get_if<std::string>(&field.value))
      ImGui::TextDisabled("%s", words->c_str());
    else if (const auto* vector = std::get_if<Vec3>(&field.value))
      ImGui::TextDisabled("%.4g, %.4g, %.4g %s", (*vector)[0], (*vector)[1], (*vector)[2], field.unit);
    else
      ImGui::TextDisabled("–");
  }

  // While a field is being written, its value is here; it is the thing's when that is done.
  void edit(Desk& desk, const AnyId& thing, FieldReading& field) {
    FieldReading& value = edited_ == field.name && edited_of_ == thing ? draft_ : field;
    bool changed = false;
    if (auto* number = std::get_if<double>(&value.value)) {
      changed = ImGui::InputDouble("##number", number, 0.0, 0.0, "%.6g");
    } else if (auto* boolean = std::get_if<bool>(&value.value)) {
      if (ImGui::Checkbox("##box", boolean)) desk.wishes.edit = Edit{thing, value};
      return;
    } else if (auto* words = std::get_if<std::string>(&value.value)) {
      changed = ImGui::InputText("##words", words);
    } else if (auto* vector = std::get_if<Vec3>(&value.value)) {
      double xyz[3] = {(*vector)[0], (*vector)[1], (*vector)[2]};
      changed = ImGui::InputScalarN("##vec", ImGuiDataType_Double, xyz, 3, nullptr, nullptr, "%.3g");
      *vector = vec(xyz[0], xyz[1], xyz[2]);
    } else {
      return tell(field);
    }
    if (changed) {
      edited_ = field.name;
      edited_of_ = thing;
      if (&value != &draft_) draft_ = value;
    }
    if (edited_ != field.name || !(edited_of_ == thing)) return;
    if (ImGui::IsItemDeactivatedAfterEdit()) desk.wishes.edit = Edit{thing, value};
    if (!ImGui::IsItemActive()) {
      edited_.clear();
      seen_ = {};
    }
  }

  AnyId shown_, read_of_;
  SeenState seen_;
  std::vector<ThingRead> things_;
  std::string edited_;  ///< name of the field that is being written, of
  AnyId edited_of_;
  FieldReading draft_{};
};

}  // namespace

std::unique_ptr<Pane> make_inspector_pane() { return std::make_unique<InspectorPane>(); }

}  // namespace pantin::player
