// The fonts of one editor: others are baked as soon as it writes characters that these lack, or at
// another scale.
//
//   GrowingFonts fonts(nullptr, 1);
//   if (*fonts.Fit(scale, now)) fonts->UseInContext();   // before a frame
//   ... the frame ...
//   if (fonts.AreLacking(now)) ...                       // draw again, nobody sees this frame
#ifndef COPPICE_EDITOR_THEME_GROWING_FONTS_H_
#define COPPICE_EDITOR_THEME_GROWING_FONTS_H_

#include <memory>
#include <string_view>

#include "bt_core/base/outcome.h"
#include "editor/theme/fonts.h"

namespace coppice::editor {

class GrowingFonts {
 public:
  /// Begins with these, or if there are none with its own; takes them again when they fit.
  GrowingFonts(std::shared_ptr<const Fonts> given, float scale);

  const Fonts& operator*() const { return *fonts_; }
  const Fonts* operator->() const { return fonts_.get(); }

  /// A text that will be shown: what it needs is baked before, and no more; a window that begins
  /// has done so.
  void Expect(std::string_view text);
  /// Whether something was written that Fit() would bake now. Since a robot can send other
  /// characters in every tick, it does so once a second.
  bool AreLacking(double now);
  /// Seconds until it would bake what is lacking; infinity if nothing is.
  double NextBakeIn(double now) const;

  /// True if other fonts are used from now on. With a problem the old ones stay.
  Expected<bool> Fit(float scale, double now);

 private:
  bool LacksExpected() const;

  std::shared_ptr<const Fonts> given_;
  std::shared_ptr<const Fonts> fonts_;
  CharacterSet expected_;  // what was to be shown until now, beyond the usual characters
  double baked_at_ = -1e9;
  bool can_bake_ = true;  // the files of the fonts are there
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_GROWING_FONTS_H_
