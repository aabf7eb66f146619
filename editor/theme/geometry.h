// Points and boxes of the canvas, in pixels; x to the right, y down.
#ifndef COPPICE_EDITOR_THEME_GEOMETRY_H_
#define COPPICE_EDITOR_THEME_GEOMETRY_H_

#include <algorithm>

namespace coppice::editor {

struct Point {
  float x = 0;
  float y = 0;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(Point a, float k) { return {a.x * k, a.y * k}; }
inline bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }

struct Box {
  Point min;
  Point max;

  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  Point center() const { return (min + max) * 0.5F; }
  bool Contains(Point p) const {
    return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y;
  }
  bool Overlaps(const Box& other) const {
    return min.x < other.max.x && other.min.x < max.x && min.y < other.max.y && other.min.y < max.y;
  }
};

inline bool operator==(const Box& a, const Box& b) { return a.min == b.min && a.max == b.max; }

/// The smallest box around both.
inline Box Union(const Box& a, const Box& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

/// Of what lies in both; 0 if they do not overlap.
inline float CommonArea(const Box& a, const Box& b) {
  const float width = std::min(a.max.x, b.max.x) - std::max(a.min.x, b.min.x);
  const float height = std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y);
  return width > 0 && height > 0 ? width * height : 0;
}

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_GEOMETRY_H_
