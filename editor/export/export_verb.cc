#include "editor/export/export_verb.h"

#include <iostream>
#include <memory>
#include <optional>

#include "editor/export/verb_options.h"

namespace coppice::editor {
namespace {

struct ExportOrder {
  PictureOrder picture;
  std::string file;
  std::vector<std::string> trees;
  bool all = false;
  bool closed = false;
};

// Says what is wrong and gives nothing.
std::nullopt_t Refuse(const std::string& what) {
  std::cerr << "coppice export: " << what << "\n";
  return std::nullopt;
}

Expected<ExportOrder> ReadOrder(const Options& options) {
  const auto picture = ReadPictureOrder(options);
  if (!picture) return Problem{picture.problem()};
  ExportOrder order;
  order.picture = *picture;
  order.file = options.files.front();
  order.trees = options.GetAll("--tree");
  order.all = options.Has("--all");
  order.closed = order.all || options.Has("--closed");
  return order;
}

// Numbers of the trees that were asked for.
std::optional<std::vector<int>> ChooseTrees(const Forest& forest, const ExportOrder& order) {
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

const Command& ExportCommand() {
  static const Command command{
      "coppice export",
      "paint trees as SVG, PDF, PNG, DOT or Markdown",
      {"FILE.xml", 1, 1},
      "Writes a picture of a whole tree, its SubTrees written out in place.",
      Together({CommandOption::Text("--tree", "ID",
                                    "this tree; else the main one. May be given several times"),
                CommandOption::Flag("--all", "every tree of the files, SubTrees closed"),
                CommandOption::Flag("--closed", "SubTrees closed")},
               PictureOptions())};
  return command;
}

int RunExport(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(ExportCommand(), arguments);
  if (options.exit) return *options.exit;
  const Expected<ExportOrder> order = ReadOrder(options);
  if (!order) return RefuseOptions(ExportCommand(), order.problem());
  if (order->picture.path.empty()) {
    return RefuseOptions(ExportCommand(),
                         "needs -o and a name that ends in " + std::string(kPictureEndings));
  }
  Diagnostics diagnostics;
  const Forest forest = Forest::FromFile(order->file, diagnostics);
  const NodeModels models = ModelsFor(forest, order->picture.models, diagnostics);
  std::cerr << diagnostics.ToString();
  const auto numbers = ChooseTrees(forest, *order);
  if (!numbers) return 2;
  TreePainting painting = order->picture.painting;
  std::vector<std::unique_ptr<const Scene>> scenes;
  for (const int number : *numbers) {
    auto scene = std::make_unique<const Scene>(order->closed ? BuildScene(forest, number, models, 0)
                                                             : BuildScene(forest, number, models));
    if (scene->nodes.empty()) continue;
    painting.trees.push_back({scene.get(), scene->tree_id, nullptr});
    scenes.push_back(std::move(scene));
  }
  if (scenes.empty()) {
    std::cerr << "coppice export: " << order->file << " has no tree to paint\n";
    return 1;
  }
  const Outcome written = WritePicture(painting, order->picture.path, order->picture.pixels);
  if (!written) std::cerr << "coppice export: " << written.problem() << "\n";
  return written ? 0 : 1;
}

}  // namespace coppice::editor
