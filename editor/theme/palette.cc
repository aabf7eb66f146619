#include "editor/theme/palette.h"

#include <algorithm>
#include <cmath>

#include "editor/theme/contrast.h"

namespace coppice::editor {
namespace {

constexpr Color Rgb(std::uint32_t rgb) {
  return 0xFF000000U | ((rgb & 0xFFU) << 16) | (rgb & 0xFF00U) | (rgb >> 16);
}

Palette Dark() {
  Palette p{};
  p.canvas = Rgb(0x14161C);
  p.panel = Rgb(0x1E2129);
  p.header = Rgb(0x262A34);
  p.border = Rgb(0x343A47);
  p.field = Rgb(0x181B22);
  p.row_hover = Rgb(0x272C37);
  p.row_selected = Rgb(0x26354C);
  p.text = Rgb(0xE4E7ED);
  p.text_dim = Rgb(0x9FA7B6);
  p.text_on_header = Rgb(0xFFFFFF);
  p.accent = Rgb(0x6AA7F5);
  p.link = Rgb(0x4FC4C0);
  p.node_body = Rgb(0x242832);
  p.node_border = Rgb(0x626B7E);
  p.edge = Rgb(0x6A7386);
  p.chip = Rgb(0x2C4148);
  p.chip_text = Rgb(0x63D2C6);
  p.control = Rgb(0x60468C);
  p.decorator = Rgb(0x1E666B);
  p.action = Rgb(0x2A548C);
  p.condition = Rgb(0x7C5C1F);
  p.subtree = Rgb(0x464E60);
  p.unknown = Rgb(0x4A4A52);
  p.running = Rgb(0xF0AA28);
  p.success = Rgb(0x46BE64);
  p.failure = Rgb(0xE15046);
  p.skipped = Rgb(0x8C93A0);
  p.halted = Rgb(0xA878E0);
  p.warning = Rgb(0xE8D44D);
  p.error = Rgb(0xF77F75);
  p.changed = Rgb(0xC98AF2);
  p.note = Rgb(0xC9B458);
  p.simulation = Rgb(0xB69CF5);
  p.note_text = Rgb(0x201B08);
  p.is_dark = true;
  return p;
}

Palette Light() {
  Palette p = Dark();
  p.canvas = Rgb(0xF4F5F8);
  p.panel = Rgb(0xFFFFFF);
  p.header = Rgb(0xE6E9EF);
  p.border = Rgb(0xC6CBD6);
  p.field = Rgb(0xF1F3F7);
  p.row_hover = Rgb(0xECEFF5);
  p.row_selected = Rgb(0xDCE9FB);
  p.text = Rgb(0x1D2129);
  p.text_dim = Rgb(0x565E6B);
  p.accent = Rgb(0x1F5FB8);
  p.link = Rgb(0x0A6E6A);
  p.node_body = Rgb(0xFFFFFF);
  p.node_border = Rgb(0x868E9D);
  p.edge = Rgb(0x868E9D);
  p.chip = Rgb(0xDDF0EE);
  p.chip_text = Rgb(0x0B6E6A);
  p.control = Rgb(0x664A99);
  p.decorator = Rgb(0x196A70);
  p.action = Rgb(0x2F65AD);
  p.condition = Rgb(0x82611A);
  p.subtree = Rgb(0x5A6478);
  p.running = Rgb(0xC07800);
  p.success = Rgb(0x1B8A3D);
  p.failure = Rgb(0xCF3A30);
  p.skipped = Rgb(0x767D8A);
  p.halted = Rgb(0x8A50D0);
  p.warning = Rgb(0x75640A);
  p.changed = Rgb(0x9438C4);
  p.error = Rgb(0xB92A22);
  p.note = Rgb(0xFFF0A8);
  p.simulation = Rgb(0x6B46B8);
  p.note_text = Rgb(0x4A4010);
  p.is_dark = false;
  return p;
}

Palette ColourBlind() {
  Palette p = Dark();
  p.running = Rgb(0xE69F00);
  p.success = Rgb(0x009E73);
  p.failure = Rgb(0xD55E00);
  p.halted = Rgb(0xCC79A7);
  p.skipped = Rgb(0xC9CDD6);
  p.warning = Rgb(0xF0E442);
  p.changed = Rgb(0xB78CFF);
  p.error = Rgb(0xFF8A4C);
  p.accent = Rgb(0x56B4E9);
  return p;
}

// Colours of statuses are for areas and lines; as writing some of them need more contrast.
Palette WithWriting(Palette p) {
  const auto written = [&p](Color color) {
    return Readable(
        color, p.text,
        {p.panel, p.header, p.canvas, p.field, p.row_hover, p.row_selected, p.node_body});
  };
  p.running_text = written(p.running);
  p.success_text = written(p.success);
  p.failure_text = written(p.failure);
  p.skipped_text = written(p.skipped);
  return p;
}

}  // namespace

const char* ToString(PaletteName name) {
  switch (name) {
    case PaletteName::kDark:
      return "dark";
    case PaletteName::kLight:
      return "light";
    case PaletteName::kColourBlind:
      return "colourblind";
  }
  return "?";
}

std::optional<PaletteName> PaletteFromString(std::string_view text) {
  for (const PaletteName name :
       {PaletteName::kDark, PaletteName::kLight, PaletteName::kColourBlind}) {
    if (text == ToString(name)) return name;
  }
  return std::nullopt;
}

const Palette& GetPalette(PaletteName name) {
  static const Palette kPalettes[] = {WithWriting(Dark()), WithWriting(Light()),
                                      WithWriting(ColourBlind())};
  return kPalettes[static_cast<std::size_t>(name)];
}

Color Palette::Of(Status status) const {
  switch (status) {
    case Status::kIdle:
      return node_border;
    case Status::kRunning:
      return running;
    case Status::kSuccess:
      return success;
    case Status::kFailure:
      return failure;
    case Status::kSkipped:
      return skipped;
  }
  return node_border;
}

Color Palette::TextOf(Status status) const {
  switch (status) {
    case Status::kIdle:
      return text_dim;
    case Status::kRunning:
      return running_text;
    case Status::kSuccess:
      return success_text;
    case Status::kFailure:
      return failure_text;
    case Status::kSkipped:
      return skipped_text;
  }
  return text_dim;
}

Color Palette::Of(Shape shape) const {
  switch (shape) {
    case Shape::kControl:
      return control;
    case Shape::kDecorator:
      return decorator;
    case Shape::kAction:
      return action;
    case Shape::kCondition:
      return condition;
    case Shape::kSubTree:
      return subtree;
    case Shape::kUnknown:
      return unknown;
  }
  return unknown;
}

Color Palette::OfKey(std::string_view key) const {
  std::uint32_t hash = 2166136261U;  // FNV-1a
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  hash ^= hash >> 15;
  // No amber, which is RUNNING.
  constexpr std::uint32_t kOnDark[] = {0x63D2C6, 0x8FB7FF, 0xE8A594, 0xC79BF2,
                                       0x8FD37A, 0xF09CB5, 0x6CC7EA, 0xBFD06C};
  constexpr std::uint32_t kOnLight[] = {0x0B6E6A, 0x2457B0, 0x96402A, 0x6A35A5,
                                        0x2F7320, 0xA32C56, 0x0B6A91, 0x4F6600};
  const std::uint32_t choice = hash % std::size(kOnDark);
  return Rgb(is_dark ? kOnDark[choice] : kOnLight[choice]);
}

Color Fade(Color color, float factor) {
  const float alpha = static_cast<float>(color >> 24) * std::clamp(factor, 0.0F, 1.0F);
  return (color & 0x00FFFFFFU) | (static_cast<Color>(std::lround(alpha)) << 24);
}

Color Mix(Color a, Color b, float t) {
  Color mixed = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto from = static_cast<float>((a >> shift) & 0xFFU);
    const auto to = static_cast<float>((b >> shift) & 0xFFU);
    mixed |= static_cast<Color>(std::lround(from + (to - from) * t)) << shift;
  }
  return mixed;
}

}  // namespace coppice::editor
