// The colours of the editor: dark, light, and one for the colour-blind.
//
// Colours are packed as Dear ImGui packs them (0xAABBGGRR). The statuses of the colour-blind
// palette are those of M. Okabe and K. Ito, "Color Universal Design", 2008.
#ifndef COPPICE_EDITOR_THEME_PALETTE_H_
#define COPPICE_EDITOR_THEME_PALETTE_H_

#include <cstdint>
#include <optional>
#include <string_view>

#include "bt_core/base/status.h"
#include "editor/scene/scene.h"

namespace coppice::editor {

using Color = std::uint32_t;

enum class PaletteName : std::uint8_t { kDark, kLight, kColourBlind };

/// "dark", "light" or "colourblind".
const char* ToString(PaletteName name);
std::optional<PaletteName> PaletteFromString(std::string_view text);

struct Palette {
  Color canvas, panel, header, border, field, row_hover, row_selected;  // surfaces
  Color text, text_dim, text_on_header, accent, link;                   // writing
  Color node_body, node_border, edge, chip, chip_text;                  // nodes at rest
  Color control, decorator, action, condition, subtree, unknown;        // headers by shape
  Color running, success, failure, skipped, halted;                     // statuses, as graphics
  Color running_text, success_text, failure_text, skipped_text;         // the same, as writing
  Color warning, error;   ///< amber is kept for what runs
  Color changed;          ///< of what differs from another version or run
  Color simulation;       ///< what is no robot
  Color note, note_text;  ///< of XML comments
  bool is_dark;

  Color Of(Status status) const;      ///< kIdle: node_border
  Color TextOf(Status status) const;  ///< readable on every surface
  Color Of(Shape shape) const;        ///< of the header
  /// A colour for a blackboard key: the same key always gets the same one.
  Color OfKey(std::string_view key) const;
};

const Palette& GetPalette(PaletteName name);

/// The same colour, alpha multiplied by `factor` in [0, 1].
Color Fade(Color color, float factor);

/// From a to b: t = 0 gives a, 1 gives b.
Color Mix(Color a, Color b, float t);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_PALETTE_H_
