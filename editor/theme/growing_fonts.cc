#include "editor/theme/growing_fonts.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace coppice::editor {
namespace {

constexpr double kPeriod = 1;  // s

}  // namespace

GrowingFonts::GrowingFonts(std::shared_ptr<const Fonts> given, float scale)
    : given_(std::move(given)), fonts_(given_ ? given_ : std::make_shared<const Fonts>(scale)) {}

void GrowingFonts::Expect(std::string_view text) { expected_.merge(UnusualCharacters(text)); }

bool GrowingFonts::AreLacking(double now) {
  expected_.merge(WithAlphabets(fonts_->TakeLacking()));
  return NextBakeIn(now) <= 0;
}

double GrowingFonts::NextBakeIn(double now) const {
  if (!can_bake_ || !LacksExpected()) return std::numeric_limits<double>::infinity();
  return std::max(baked_at_ + kPeriod - now, 0.0);
}

Expected<bool> GrowingFonts::Fit(float scale, double now) {
  if (scale == fonts_->scale() && NextBakeIn(now) > 0) return false;
  expected_.insert(fonts_->more().begin(), fonts_->more().end());
  const bool is_given = given_ && given_->scale() == scale && given_->more() == expected_;
  auto fonts = is_given ? given_ : std::make_shared<const Fonts>(scale, expected_);
  can_bake_ = fonts->error().empty();
  if (!can_bake_) return Problem{fonts->error()};
  fonts_ = std::move(fonts);
  baked_at_ = now;
  return true;
}

bool GrowingFonts::LacksExpected() const {
  return !std::includes(fonts_->more().begin(), fonts_->more().end(), expected_.begin(),
                        expected_.end());
}

}  // namespace coppice::editor
