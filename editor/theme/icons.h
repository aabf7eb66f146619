// Glyphs as UTF-8: Font Awesome 4.7 (private use area) and arrows of DejaVu. A glyph that is used
// anywhere must be listed in fonts.cc as well, or it is drawn as '?'.
#ifndef COPPICE_EDITOR_THEME_ICONS_H_
#define COPPICE_EDITOR_THEME_ICONS_H_

namespace coppice::editor::icon {

inline constexpr char kSearch[] = "\xEF\x80\x82";       // f002
inline constexpr char kCheck[] = "\xEF\x80\x8C";        // f00c
inline constexpr char kTimes[] = "\xEF\x80\x8D";        // f00d
inline constexpr char kClock[] = "\xEF\x80\x97";        // f017
inline constexpr char kPin[] = "\xEF\x82\x8D";          // f08d
inline constexpr char kRepeat[] = "\xEF\x80\x9E";       // f01e
inline constexpr char kRefresh[] = "\xEF\x80\xA1";      // f021
inline constexpr char kStepBack[] = "\xEF\x81\x88";     // f048
inline constexpr char kPlay[] = "\xEF\x81\x8B";         // f04b
inline constexpr char kPause[] = "\xEF\x81\x8C";        // f04c
inline constexpr char kStop[] = "\xEF\x81\x8D";         // f04d
inline constexpr char kStepForward[] = "\xEF\x81\x91";  // f051
inline constexpr char kCaretDown[] = "\xEF\x83\x97";    // f0d7
inline constexpr char kForward[] = "\xEF\x81\x8E";      // f04e
inline constexpr char kQuestion[] = "\xEF\x81\x99";     // f059
inline constexpr char kWarning[] = "\xEF\x81\xB1";      // f071
inline constexpr char kFolder[] = "\xEF\x81\xBB";       // f07b
inline constexpr char kFolderOpen[] = "\xEF\x81\xBC";   // f07c
inline constexpr char kCogs[] = "\xEF\x82\x85";         // f085
inline constexpr char kBolt[] = "\xEF\x83\xA7";         // f0e7
inline constexpr char kSitemap[] = "\xEF\x83\xA8";      // f0e8
inline constexpr char kCircle[] = "\xEF\x84\x91";       // f111
inline constexpr char kCircleOpen[] = "\xEF\x84\x8C";   // f10c
inline constexpr char kCode[] = "\xEF\x84\xA1";         // f121
inline constexpr char kFork[] = "\xEF\x84\xA6";         // f126
inline constexpr char kShield[] = "\xEF\x84\xB2";       // f132
inline constexpr char kFileCode[] = "\xEF\x87\x89";     // f1c9
inline constexpr char kPlug[] = "\xEF\x87\xA6";         // f1e6
inline constexpr char kHourglass[] = "\xEF\x89\x92";    // f252
inline constexpr char kPlusSquare[] = "\xEF\x83\xBE";   // f0fe
inline constexpr char kMinusSquare[] = "\xEF\x85\x86";  // f146
inline constexpr char kExclamation[] = "\xEF\x81\xAA";  // f06a

inline constexpr char kRightArrow[] = "\xE2\x86\x92";    // U+2192
inline constexpr char kDoubleArrows[] = "\xE2\x87\x89";  // U+21C9
inline constexpr char kEllipsis[] = "\xE2\x80\xA6";      // U+2026
inline constexpr char kAngle[] = "\xE2\x80\xBA";         // U+203A
inline constexpr char kMiddleDot[] = "\xC2\xB7";         // U+00B7
inline constexpr char kTimesSign[] = "\xC3\x97";         // U+00D7

}  // namespace coppice::editor::icon

#endif  // COPPICE_EDITOR_THEME_ICONS_H_
