#include "editor/export/verb_options.h"

#include <cstdlib>

namespace coppice::editor {
namespace {

std::optional<float> ScaleOf(const std::string& text) {
  char* end = nullptr;
  const float scale = std::strtof(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(scale >= 0.25F && scale <= 4)) return std::nullopt;
  return scale;
}

}  // namespace

const char* const kPictureUsage =
    "  --across          from left to right instead of from top to bottom\n"
    "  --compact         decorators lie on their children\n"
    "  --layered         all nodes of a depth begin at the same line\n"
    "  --palette NAME    light (else), dark or colourblind\n"
    "  --scale N         pixels of a .png for one at 100 % (2), from 0.25 to 4\n"
    "  --models FILE     XML with a <TreeNodesModel>; may be given several times\n";

std::vector<std::string> PictureOptions() { return {"-o", "--palette", "--scale", "--models"}; }

std::vector<std::string> PictureFlags() { return {"--across", "--compact", "--layered"}; }

std::optional<PictureOrder> ReadPictureOrder(const Options& options, std::string& wrong) {
  PictureOrder order;
  order.path = options.Get("-o");
  if (options.Has("-o") && !FormatOf(order.path)) {
    wrong = "-o needs a name that ends in " + std::string(kPictureEndings);
    return std::nullopt;
  }
  const auto palette = PaletteFromString(options.Get("--palette", "light"));
  if (!palette) {
    wrong = "--palette expects light, dark or colourblind";
    return std::nullopt;
  }
  const auto scale = ScaleOf(options.Get("--scale", "2"));
  if (!scale) {
    wrong = "--scale expects a number from 0.25 to 4";
    return std::nullopt;
  }
  order.pixels = *scale;
  order.models = options.GetAll("--models");
  order.painting.palette = *palette;
  order.painting.style.compact = options.Has("--compact");
  order.painting.style.layered = options.Has("--layered");
  if (options.Has("--across")) {
    order.painting.style.orientation = Orientation::kLeftToRight;
  }
  return order;
}

NodeModels ModelsFor(const Forest& forest, const std::vector<std::string>& files,
                     Diagnostics& diagnostics) {
  NodeModels models;
  for (const std::string& file : files) {
    if (const auto document = Document::FromFile(file, diagnostics)) models.AddFrom(*document);
  }
  for (const Document* document : forest.documents()) models.AddFrom(*document);
  return models;
}

}  // namespace coppice::editor
