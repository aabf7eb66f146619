// Which characters a text needs, beyond the usual ones that are always baked (fonts.h).
#ifndef COPPICE_EDITOR_THEME_CHARACTERS_H_
#define COPPICE_EDITOR_THEME_CHARACTERS_H_

#include <imgui.h>

#include <set>
#include <string_view>

namespace coppice::editor {

/// Unicode, up to U+FFFF: Dear ImGui knows no more.
using CharacterSet = std::set<ImWchar>;

/// ASCII and what the editor itself writes, as ranges for Dear ImGui; ends with 0.
const ImWchar* UsualCharacters();

/// The characters of a text in UTF-8 that are not usual ones.
CharacterSet UnusualCharacters(std::string_view text);

/// These, and all letters of the alphabets (Latin, Greek, Cyrillic) that they are of: where one is,
/// others follow.
CharacterSet WithAlphabets(const CharacterSet& characters);

/// All of these alphabets.
CharacterSet Alphabets();

/// Of the scripts of East Asia, for which there is another font.
bool IsEastAsian(ImWchar character);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_CHARACTERS_H_
