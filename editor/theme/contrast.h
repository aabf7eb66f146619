// Can it be read, and can it be told apart? Contrast as in WCAG 2.1, colour blindness as in
// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A Physiologically-based Model for Simulation
// of Color Vision Deficiency", IEEE TVCG 2009.
#ifndef COPPICE_EDITOR_THEME_CONTRAST_H_
#define COPPICE_EDITOR_THEME_CONTRAST_H_

#include <initializer_list>

#include "editor/theme/palette.h"

namespace coppice::editor {

inline constexpr double kReadable = 4.5;  ///< least contrast of text (WCAG AA)
inline constexpr double kVisible = 3.0;   ///< least contrast of graphics that tell something

/// From 1 (none) to 21 (black on white). Alpha does not count.
double Contrast(Color a, Color b);

/// The colour, or as much of `text` in it as makes it readable on each of the surfaces.
Color Readable(Color color, Color text, std::initializer_list<Color> surfaces);

/// Black or white: what is read better on it. At least 4.58 on any colour.
Color WritingOn(Color surface);

enum class Vision { kNormal, kProtanopia, kDeuteranopia, kTritanopia };

/// How different two colours look to people with that vision: the distance in CIELAB (CIE 1976).
/// One is just noticeable side by side; from 15 on nobody mixes them up.
double Difference(Color a, Color b, Vision vision);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_CONTRAST_H_
