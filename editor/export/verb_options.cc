#include "editor/export/verb_options.h"

namespace coppice::editor {
std::vector<CommandOption> PictureOptions() {
  return {CommandOption::Text("-o", "PICTURE", std::string("ends in ") + kPictureEndings),
          CommandOption::Flag("--across", "from left to right instead of from top to bottom"),
          CommandOption::Flag("--compact", "decorators lie on their children"),
          CommandOption::Flag("--layered", "all nodes of a depth begin at the same line"),
          CommandOption::OneOf("--palette", {"light", "dark", "colourblind"}, "else light"),
          CommandOption::Real("--scale", "N", 0.25, 4, "pixels of a .png for one at 100 %; else 2"),
          CommandOption::Text("--models", "FILE",
                              "XML with a <TreeNodesModel>; may be given several times")};
}

Expected<PictureOrder> ReadPictureOrder(const Options& options) {
  PictureOrder order;
  order.path = options.Get("-o");
  if (options.Has("-o") && !FormatOf(order.path)) {
    return Problem{"-o needs a name that ends in " + std::string(kPictureEndings)};
  }
  order.pixels = static_cast<float>(options.Real("--scale", 2));
  order.models = options.GetAll("--models");
  order.painting.palette = *PaletteFromString(options.Get("--palette", "light"));
  order.painting.style.compact = options.Has("--compact");
  order.painting.style.layered = options.Has("--layered");
  if (options.Has("--across")) order.painting.style.growth = Growth::kAcross;
  return order;
}

NodeModels ModelsFor(const Forest& forest, const std::vector<std::string>& files,
                     Diagnostics& diagnostics) {
  std::vector<Document> read;
  for (const std::string& file : files) {
    if (auto document = Document::FromFile(file, diagnostics)) read.push_back(std::move(*document));
  }
  std::vector<const Document*> given;
  for (const Document& document : read) given.push_back(&document);
  return ModelsFor(given, forest.documents());
}

}  // namespace coppice::editor
