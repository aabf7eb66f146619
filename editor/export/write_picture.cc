#include "editor/export/write_picture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <utility>

#include "bt_core/model/write_file.h"
#include "editor/export/outline_texts.h"
#include "editor/export/pdf.h"
#include "editor/export/svg.h"

namespace coppice::editor {
namespace {

constexpr std::pair<const char*, PictureFormat> kEndings[] = {{".svg", PictureFormat::kSvg},
                                                              {".pdf", PictureFormat::kPdf},
                                                              {".png", PictureFormat::kPng},
                                                              {".dot", PictureFormat::kDot},
                                                              {".md", PictureFormat::kMarkdown}};

std::vector<const Scene*> ScenesOf(const TreePainting& painting) {
  std::vector<const Scene*> scenes;
  for (const PaintedTree& tree : painting.trees) scenes.push_back(tree.scene);
  return scenes;
}

Outcome WriteText(const std::string& path, const std::string& text) {
  Diagnostics diagnostics;
  if (WriteFile(path, text, diagnostics)) return {};
  std::string wrong = path;
  for (const Diagnostic& problem : diagnostics.all()) wrong += ": " + problem.message;
  return Problem{wrong};
}

}  // namespace

const char* const kPictureEndings = ".svg, .pdf, .png, .dot or .md";

std::optional<PictureFormat> FormatOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [known, format] : kEndings) {
    if (ending == known) return format;
  }
  return std::nullopt;
}

Outcome WritePicture(const TreePainting& painting, const std::string& path, float pixels) {
  const std::optional<PictureFormat> format = FormatOf(path);
  if (!format) return Problem{"the name of a picture ends in " + std::string(kPictureEndings)};
  if (format == PictureFormat::kDot) return WriteText(path, ToDot(ScenesOf(painting)));
  if (format == PictureFormat::kMarkdown) return WriteText(path, ToMarkdown(ScenesOf(painting)));
  PictureMaker maker(format == PictureFormat::kPng ? pixels : 1);
  if (!maker.error().empty()) return Problem{maker.error()};
  if (format == PictureFormat::kPng) return WritePng(maker.Paint(painting), path);
  const Glyphs glyphs;
  const Drawing drawing = maker.Draw(painting);
  return WriteText(path,
                   format == PictureFormat::kSvg ? ToSvg(drawing, glyphs) : ToPdf(drawing, glyphs));
}

}  // namespace coppice::editor
