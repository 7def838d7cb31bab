#include "view/chart_board_vtk.hpp"

#include <vtkContextMouseEvent.h>
#include <vtkContextScene.h>
#include <vtkTooltipItem.h>
#include <vtkVector.h>

#include <algorithm>
#include <memory>

namespace fingerpad {
namespace {

vtkContextMouseEvent mouse_event(int x, int y, int last_x, int last_y, int button) {
  vtkContextMouseEvent event;
  const vtkVector2i at(x, y), before(last_x, last_y);
  const vtkVector2f at_f(static_cast<float>(x), static_cast<float>(y));
  const vtkVector2f before_f(static_cast<float>(last_x), static_cast<float>(last_y));
  event.SetScreenPos(at);
  event.SetLastScreenPos(before);
  event.SetPos(at_f);
  event.SetScenePos(at_f);
  event.SetLastPos(before_f);
  event.SetLastScenePos(before_f);
  event.SetButton(button);
  return event;
}

}  // namespace

std::vector<vtkAbstractContextItem*> ChartBoard::items() {
  return {words_, matrix_};
}

void ChartBoard::add_to(vtkContextScene* scene) {
  for (vtkAbstractContextItem* item : items()) scene->AddItem(item);
}

void ChartBoard::build(const ChartLayout& layout) {
  held_ = hovered_ = nullptr;
  panels_.clear();
  matrix_->SetSize(vtkVector2i(0, 0));
  matrix_->SetSize(vtkVector2i(layout.columns, layout.rows));
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    const int column = static_cast<int>(i) % layout.columns, row = static_cast<int>(i) / layout.columns;
    panels_.push_back(vtkSmartPointer<PanelChart>::New());
    matrix_->SetChart(vtkVector2i(column, layout.rows - 1 - row), panels_.back());  // VTK counts from below
  }
}

void ChartBoard::show(const Chart& chart, const ChartLayout& layout, int width, int height) {
  ++changes_;
  const bool fits = panels_.size() == layout.panels.size() && layout_.columns == layout.columns;
  if (!fits) build(layout);
  layout_ = layout;
  if (layout.panels.empty()) return;
  const Box& lowest = layout.panels.back().frame;
  const Box& first = layout.panels.front().frame;
  const Box& last_of_row =
      layout.panels[std::min(panels_.size(), static_cast<std::size_t>(layout.columns)) - 1].frame;
  matrix_->SetBorders(static_cast<int>(first.left), static_cast<int>(lowest.bottom),
                      width - static_cast<int>(last_of_row.right()), height - static_cast<int>(first.top()));
  matrix_->SetGutter(vtkVector2f(static_cast<float>(layout.gutter_x), static_cast<float>(layout.gutter_y)));
  const ChartBand* const band = chart.band ? &*chart.band : nullptr;
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    panels_[i]->show(chart.panels[i], layout.panels[i], layout.em, band, i == 0 ? layout.strip : Box{});
    panels_[i]->set_dark(dark_);
  }
  words_->show({std::make_shared<const Drawing>(chart_words(chart, layout))});
}

ChartPlace ChartBoard::place() const {
  ChartPlace place;
  for (const ChartLayout::Panel& panel : layout_.panels) place.panels.push_back(panel.frame);
  if (panels_.empty()) return place;
  const Axis x = panels_.back()->shown_x();
  place.x_min = x.min;
  place.x_max = x.max;
  return place;
}

bool ChartBoard::zoomed() const {
  return std::any_of(panels_.begin(), panels_.end(), [](const auto& panel) { return panel->zoomed(); });
}

void ChartBoard::show_all() {
  ++changes_;
  for (const auto& panel : panels_) panel->show_all();
}

std::string ChartBoard::told() const {
  return hovered_ != nullptr && hovered_->GetTooltip()->GetVisible() ? hovered_->GetTooltip()->GetText() : "";
}

void ChartBoard::set_dark(bool dark) {
  dark_ = dark;
  for (const auto& panel : panels_) panel->set_dark(dark);
}

void ChartBoard::set_visible(bool visible) {
  visible_ = visible;
  for (vtkAbstractContextItem* item : items()) item->SetVisible(visible);
}

PanelChart* ChartBoard::panel_at(int x, int y) {
  if (!visible_) return nullptr;
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    if (layout_.panels[i].frame.holds(x, y)) return panels_[i];
  }
  return nullptr;
}

void ChartBoard::follow(const PanelChart& leader) {
  for (const auto& panel : panels_) panel->follow(leader);
}

bool ChartBoard::wheel(int x, int y, int steps) {
  PanelChart* const panel = panel_at(x, y);
  if (panel == nullptr) return false;
  ++changes_;
  panel->MouseWheelEvent(mouse_event(x, y, x, y, vtkContextMouseEvent::NO_BUTTON), steps);
  follow(*panel);
  return true;
}

bool ChartBoard::press(int x, int y) {
  held_ = panel_at(x, y);
  last_x_ = x;
  last_y_ = y;
  if (held_ == nullptr) return false;
  ++changes_;
  held_->MouseButtonPressEvent(mouse_event(x, y, x, y, vtkContextMouseEvent::LEFT_BUTTON));
  return true;
}

bool ChartBoard::move(int x, int y) {
  PanelChart* const panel = held_ != nullptr ? held_ : panel_at(x, y);
  if (hovered_ != nullptr && hovered_ != panel) {
    hovered_->MouseLeaveEvent(mouse_event(x, y, last_x_, last_y_, vtkContextMouseEvent::NO_BUTTON));
  }
  const bool left_one = hovered_ != nullptr && panel == nullptr;
  if (left_one || panel != nullptr) ++changes_;
  hovered_ = panel;
  if (panel == nullptr) return left_one;
  const int button = held_ != nullptr ? vtkContextMouseEvent::LEFT_BUTTON : vtkContextMouseEvent::NO_BUTTON;
  panel->MouseMoveEvent(mouse_event(x, y, last_x_, last_y_, button));
  // A value told reaches over the panels beside its own.
  matrix_->Raise(matrix_->GetItemIndex(panel));
  if (held_ != nullptr) follow(*held_);
  last_x_ = x;
  last_y_ = y;
  return true;
}

void ChartBoard::ask_again() {
  if (hovered_ != nullptr && held_ == nullptr) move(last_x_, last_y_);
}

bool ChartBoard::release(int x, int y) {
  if (held_ == nullptr) return false;
  ++changes_;
  held_->MouseButtonReleaseEvent(mouse_event(x, y, last_x_, last_y_, vtkContextMouseEvent::LEFT_BUTTON));
  held_ = nullptr;
  return true;
}

}  // namespace fingerpad
