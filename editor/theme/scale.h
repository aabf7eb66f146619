// How large the editor is painted: as the screen says, or as the user has chosen.
#ifndef COPPICE_EDITOR_THEME_SCALE_H_
#define COPPICE_EDITOR_THEME_SCALE_H_

namespace coppice::editor {

/// What can be chosen; 1 is an ordinary screen.
inline constexpr float kScales[] = {0.75F, 1, 1.25F, 1.5F, 1.75F, 2, 2.5F, 3};
inline constexpr float kScaleOfScreen = 0;

/// What is painted if that was chosen, on a screen that says `of_screen`.
float ShownScale(float chosen, float of_screen);

/// The next one that can be chosen, larger (by 1) or smaller (by -1); the last one stays.
float NextScale(float shown, int by);

/// The one that can be chosen and is nearest; kScaleOfScreen for what is no scale.
float NearestScale(float scale);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_SCALE_H_
