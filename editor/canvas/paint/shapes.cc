#include "editor/canvas/paint/shapes.h"

#include <algorithm>
#include <cmath>

namespace coppice::editor {
namespace {

constexpr float kQuarter = 1.57079633F;
constexpr int kStepsPerCorner = 5;

bool Touch(const ImVec2& a, const ImVec2& b) {
  return std::abs(a.x - b.x) < 0.05F && std::abs(a.y - b.y) < 0.05F;
}

void AddCorner(Outline& outline, ImVec2 center, float radius, float from) {
  for (int i = 0; i <= kStepsPerCorner; ++i) {
    const float angle = from + kQuarter * static_cast<float>(i) / kStepsPerCorner;
    const ImVec2 at = {center.x + std::cos(angle) * radius, center.y + std::sin(angle) * radius};
    if (outline.empty() || !Touch(outline.back(), at)) outline.push_back(at);
  }
}

}  // namespace

Outline RoundedBox(const Box& box, float radius) {
  radius = std::min({radius, box.width() / 2, box.height() / 2});
  if (radius < 1) {
    return {{box.min.x, box.min.y},
            {box.max.x, box.min.y},
            {box.max.x, box.max.y},
            {box.min.x, box.max.y}};
  }
  Outline outline;
  AddCorner(outline, {box.min.x + radius, box.min.y + radius}, radius, 2 * kQuarter);
  AddCorner(outline, {box.max.x - radius, box.min.y + radius}, radius, 3 * kQuarter);
  AddCorner(outline, {box.max.x - radius, box.max.y - radius}, radius, 0);
  AddCorner(outline, {box.min.x + radius, box.max.y - radius}, radius, kQuarter);
  if (Touch(outline.front(), outline.back())) outline.pop_back();  // half circles at both ends
  return outline;
}

Outline CutBox(const Box& box, float cut) {
  cut = std::min({cut, box.width() / 2, box.height() / 2});
  return {{box.min.x + cut, box.min.y}, {box.max.x - cut, box.min.y}, {box.max.x, box.min.y + cut},
          {box.max.x, box.max.y - cut}, {box.max.x - cut, box.max.y}, {box.min.x + cut, box.max.y},
          {box.min.x, box.max.y - cut}, {box.min.x, box.min.y + cut}};
}

std::vector<Outline> DashesOf(const Outline& outline, float dash) {
  std::vector<Outline> dashes;
  float walked = 0;  // since the start of the current dash or gap
  bool on = true;
  Outline line = {outline.front()};
  const auto finish = [&] {
    if (on && line.size() > 1) dashes.push_back(line);
    line.erase(line.begin(), line.end() - 1);
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    ImVec2 at = outline[i];
    const ImVec2 to = outline[(i + 1) % outline.size()];
    float length = std::hypot(to.x - at.x, to.y - at.y);
    while (length > 0) {
      const float step = std::min(length, dash - walked);
      at = {at.x + (to.x - at.x) * step / length, at.y + (to.y - at.y) * step / length};
      line.push_back(at);
      length -= step;
      walked += step;
      if (walked < dash - 1e-3F) continue;
      finish();
      on = !on;
      walked = 0;
    }
  }
  finish();
  return dashes;
}

}  // namespace coppice::editor
