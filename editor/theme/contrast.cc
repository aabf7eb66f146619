#include "editor/theme/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coppice::editor {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

// Full strength of the deficiency, on linear RGB.
constexpr Matrix kVisions[] = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                               {{{0.152286, 1.052583, -0.204868},
                                 {0.114503, 0.786281, 0.099216},
                                 {-0.003882, -0.048116, 1.051998}}},
                               {{{0.367322, 0.860646, -0.227968},
                                 {0.280085, 0.672501, 0.047413},
                                 {-0.011820, 0.042940, 0.968881}}},
                               {{{1.255528, -0.076749, -0.178779},
                                 {-0.078411, 0.930809, 0.147602},
                                 {0.004733, 0.691367, 0.303900}}}};

// Of sRGB with a white of D65.
constexpr Matrix kToXyz = {{{0.4124564, 0.3575761, 0.1804375},
                            {0.2126729, 0.7151522, 0.0721750},
                            {0.0193339, 0.1191920, 0.9503041}}};
constexpr Triple kWhite = {0.95047, 1, 1.08883};

Triple Times(const Matrix& matrix, const Triple& v) {
  Triple product{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) product[i] += matrix[i][k] * v[k];
  }
  return product;
}

Triple Linear(Color color) {
  Triple rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = ((color >> (8 * i)) & 0xFFU) / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

Triple ToLab(const Triple& rgb) {
  const Triple xyz = Times(kToXyz, rgb);
  Triple f{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = xyz[i] / kWhite[i];
    f[i] = part > 216.0 / 24389 ? std::cbrt(part) : (24389.0 / 27 * part + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double Luminance(Color color) { return Times(kToXyz, Linear(color))[1]; }

Triple Seen(Color color, Vision vision) {
  Triple rgb = Times(kVisions[static_cast<std::size_t>(vision)], Linear(color));
  for (double& part : rgb) part = std::clamp(part, 0.0, 1.0);
  return rgb;
}

}  // namespace

double Contrast(Color a, Color b) {
  const double x = Luminance(a) + 0.05;
  const double y = Luminance(b) + 0.05;
  return std::max(x, y) / std::min(x, y);
}

Color Readable(Color color, Color text, std::initializer_list<Color> surfaces) {
  constexpr float kStep = 0.05F;
  Color found = color;
  for (float part = kStep; part <= 1; part += kStep) {
    const bool readable = std::all_of(surfaces.begin(), surfaces.end(), [&](Color surface) {
      return Contrast(found, surface) >= kReadable;
    });
    if (readable) return found;
    found = Mix(color, text, part);
  }
  return text;
}

Color WritingOn(Color surface) {
  constexpr Color kBlack = 0xFF000000;
  constexpr Color kWhite = 0xFFFFFFFF;
  return Contrast(surface, kBlack) >= Contrast(surface, kWhite) ? kBlack : kWhite;
}

double Difference(Color a, Color b, Vision vision) {
  const Triple x = ToLab(Seen(a, vision));
  const Triple y = ToLab(Seen(b, vision));
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

}  // namespace coppice::editor
