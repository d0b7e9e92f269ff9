// Sliders, fields, boxes and choices for what the scene declared by `scene:param`.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "player/panels/pane.hpp"

namespace pantin::player {
namespace {

class ParametersPane : public Pane {
 public:
  bool useful(const Desk& desk) const override { return !desk.scene.parameters().empty(); }
  void draw(Desk& desk) override {
    for (const SceneParameter& p : desk.scene.parameters()) {
      ImGui::PushID(p.name.c_str());
      draw_one(desk, p);
      ImGui::PopID();
    }
  }
  void reset() override { edited_.clear(); }

 private:
  void draw_one(Desk& desk, const SceneParameter& p) {
    if (std::holds_alternative<bool>(p.value)) {
      bool value = std::get<bool>(p.value);
      if (ImGui::Checkbox(p.name.c_str(), &value)) wish(desk, p, value);
      return tell(p);
    }
    ImGui::TextUnformatted(p.name.c_str());
    tell(p);
    ImGui::SetNextItemWidth(-1.0f);
    if (!p.choices.empty()) return choose(desk, p);
    std::holds_alternative<double>(p.value) ? number(desk, p) : words(desk, p);
  }

  static void tell(const SceneParameter& p) {
    if (!p.help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", p.help.c_str());
  }

  static void wish(Desk& desk, const SceneParameter& p, const SceneValue& value) {
    desk.wishes.parameter = {p.name, value};
  }

  static std::string text_of(const SceneValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return to_text(*number);
    if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
    return std::get<std::string>(value);
  }

  static void choose(Desk& desk, const SceneParameter& p) {
    const auto* word = std::get_if<std::string>(&p.value);
    if (ImGui::BeginCombo("##choice", word ? word->c_str() : text_of(p.value).c_str())) {
      for (const SceneValue& choice : p.choices)
        if (ImGui::Selectable(text_of(choice).c_str(), choice == p.value)) wish(desk, p, choice);
      ImGui::EndCombo();
    }
    tell(p);
  }

  void words(Desk& desk, const SceneParameter& p) {
    if (edited_ != p.name) written_ = std::get<std::string>(p.value);
    if (ImGui::InputText("##words", &written_)) edited_ = p.name;
    tell(p);
    if (ImGui::IsItemDeactivatedAfterEdit()) wish(desk, p, written_);
    if (!ImGui::IsItemActive() && edited_ == p.name) edited_.clear();
  }

  // A scene that opens slowly is opened with the new value when the slider is let go.
  void number(Desk& desk, const SceneParameter& p) {
    double value = edited_ == p.name ? number_ : std::get<double>(p.value);
    const char* format = p.integer && !(p.step && *p.step != std::trunc(*p.step)) ? "%.0f" : "%.6g";
    bool changed = false;
    if (p.min && p.max) {
      const bool wide = *p.min > 0.0 && *p.max >= 1000.0 * *p.min;
      const ImGuiSliderFlags flags = wide ? ImGuiSliderFlags_Logarithmic : 0;
      const double min = *p.min, max = *p.max;
      changed = ImGui::SliderScalar("##number", ImGuiDataType_Double, &value, &min, &max, format, flags);
    } else {
      const float speed = static_cast<float>(p.step.value_or(0.01 * std::fmax(std::fabs(value), 0.1)));
      changed = ImGui::DragScalar("##number", ImGuiDataType_Double, &value, speed, nullptr, nullptr, format);
    }
    tell(p);
    if (changed) {
      edited_ = p.name;
      asked_ = value;
      number_ = allowed(p, value);
    }
    const bool done = ImGui::IsItemDeactivatedAfterEdit();
    if (done && edited_ == p.name && is_outside(p, asked_)) desk.wishes.told = range_told(p, asked_, number_);
    if (edited_ == p.name && ((changed && (p.live || desk.quick)) || done) && number_ != std::get<double>(p.value))
      wish(desk, p, number_);
    if (!ImGui::IsItemActive() && edited_ == p.name) edited_.clear();
  }

  static bool is_outside(const SceneParameter& p, double value) {
    return (p.min && value < *p.min) || (p.max && value > *p.max);
  }

  static std::string range_told(const SceneParameter& p, double asked, double taken) {
    const std::string range = p.min && p.max ? text("from ", *p.min, " to ", *p.max)
                              : p.min        ? text("at least ", *p.min)
                                             : text("at most ", *p.max);
    return text(p.name, " is ", range, ": ", asked, " became ", taken);
  }

  /// The nearest value that the parameter may have.
  static double allowed(const SceneParameter& p, double value) {
    if (p.step) {
      const double base = p.min.value_or(std::get<double>(p.initial));
      double count = std::round((value - base) / *p.step);
      if (p.max) count = std::fmin(count, std::floor((*p.max - base) / *p.step * (1.0 + 1e-12)));
      value = base + count * *p.step;
    }
    if (p.min) value = std::fmax(value, *p.min);
    if (p.max) value = std::fmin(value, *p.max);
    return value;
  }

  std::string edited_;  ///< name of the parameter whose value is here, not in the scene
  double number_ = 0.0, asked_ = 0.0;
  std::string written_;
};

}  // namespace

std::unique_ptr<Pane> make_parameters_pane() { return std::make_unique<ParametersPane>(); }

}  // namespace pantin::player
