#include "editor/export/export_verb.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

#include "bt_core/base/command_line.h"
#include "editor/export/write_picture.h"
#include "editor/scene/forest.h"

namespace coppice::editor {
namespace {

constexpr char kUsage[] =
    "coppice export FILE.xml -o PICTURE [options]\n"
    "  Writes a picture of a whole tree, its SubTrees written out in place.\n"
    "  -o PICTURE        ends in .svg, .pdf, .png, .dot or .md\n"
    "  --tree ID         this tree; else the main tree. May be given several times\n"
    "  --all             every tree of the files, SubTrees closed\n"
    "  --closed          SubTrees closed\n"
    "  --across          from left to right instead of from top to bottom\n"
    "  --compact         decorators lie on their children\n"
    "  --layered         all nodes of a depth begin at the same line\n"
    "  --palette NAME    light (else), dark or colourblind\n"
    "  --scale N         pixels of a .png for one at 100 % (2), from 0.25 to 4\n"
    "  --models FILE     XML with a <TreeNodesModel>; may be given several times\n";

struct Order {
  std::string file, picture;
  std::vector<std::string> trees, models;
  bool all = false;
  bool closed = false;
  float scale = 2;
  TreePainting painting;  // without trees
};

// Says what is wrong and gives nothing.
std::nullopt_t Refuse(const std::string& what) {
  std::cerr << "coppice export: " << what << "\n";
  return std::nullopt;
}

std::optional<float> ScaleOf(const std::string& text) {
  char* end = nullptr;
  const float scale = std::strtof(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(scale >= 0.25F && scale <= 4)) return std::nullopt;
  return scale;
}

std::optional<Order> ReadOrder(const std::vector<std::string>& arguments) {
  const std::optional<Options> options =
      ParseOptions(arguments, {"-o", "--tree", "--palette", "--scale", "--models"},
                   {"--all", "--closed", "--across", "--compact", "--layered"}, kUsage);
  if (!options) return std::nullopt;
  Order order;
  if (options->files.size() != 1) return Refuse("needs one file\nusage: " + std::string(kUsage));
  order.file = options->files.front();
  order.picture = options->Get("-o");
  if (!FormatOf(order.picture)) {
    return Refuse("-o needs a name that ends in " + std::string(kPictureEndings));
  }
  const auto palette = PaletteFromString(options->Get("--palette", "light"));
  if (!palette) return Refuse("--palette expects light, dark or colourblind");
  const auto scale = ScaleOf(options->Get("--scale", "2"));
  if (!scale) return Refuse("--scale expects a number from 0.25 to 4");
  order.scale = *scale;
  order.trees = options->GetAll("--tree");
  order.models = options->GetAll("--models");
  order.all = options->Has("--all");
  order.closed = order.all || options->Has("--closed");
  order.painting.palette = *palette;
  order.painting.style.compact = options->Has("--compact");
  order.painting.style.layered = options->Has("--layered");
  if (options->Has("--across")) {
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

// Numbers of the trees that were asked for.
std::optional<std::vector<int>> ChooseTrees(const Forest& forest, const Order& order) {
  std::vector<int> numbers;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < forest.trees().size(); ++i) {
    ids.push_back(forest.trees()[i].id);
    if (order.all) numbers.push_back(static_cast<int>(i));
  }
  if (order.all) return numbers;
  for (const std::string& id : order.trees) {
    const int number = forest.Find(id);
    if (number < 0) {
      return Refuse(order.file + " has no tree \"" + id + "\" " + DidYouMean(id, ids));
    }
    numbers.push_back(number);
  }
  if (numbers.empty() && forest.main_tree() >= 0) numbers.push_back(forest.main_tree());
  return numbers;
}

}  // namespace

int RunExport(const std::vector<std::string>& arguments) {
  std::optional<Order> order = ReadOrder(arguments);
  if (!order) return 2;
  Diagnostics diagnostics;
  const Forest forest = Forest::FromFile(order->file, diagnostics);
  const NodeModels models = ModelsFor(forest, order->models, diagnostics);
  std::cerr << diagnostics.ToString();
  const auto numbers = ChooseTrees(forest, *order);
  if (!numbers) return 2;
  std::vector<std::unique_ptr<const Scene>> scenes;
  for (const int number : *numbers) {
    auto scene = std::make_unique<const Scene>(order->closed ? BuildScene(forest, number, models, 0)
                                                             : BuildScene(forest, number, models));
    if (scene->nodes.empty()) continue;
    order->painting.trees.push_back({scene.get(), scene->tree_id, nullptr});
    scenes.push_back(std::move(scene));
  }
  if (scenes.empty()) {
    std::cerr << "coppice export: " << order->file << " has no tree to paint\n";
    return 1;
  }
  const std::string wrong = WritePicture(order->painting, order->picture, order->scale);
  if (!wrong.empty()) std::cerr << "coppice export: " << wrong << "\n";
  return wrong.empty() ? 0 : 1;
}

}  // namespace coppice::editor
