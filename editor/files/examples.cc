#include "editor/files/examples.h"

#include <filesystem>
#include <system_error>

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

struct Shipped {
  const char* title;
  const char* name;
};
constexpr Shipped kShipped[] = {{"Delivery: a tree", "delivery.xml"},
                                {"Delivery: a record of a run", "delivery.coppice"}};

fs::path Folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/coppice/examples";
  return !error && fs::exists(installed, error) ? installed : fs::path(COPPICE_EXAMPLES);
}

}  // namespace

std::string PathOfExample(const std::string& name) {
  static const fs::path folder = Folder();
  return (folder / name).string();
}

namespace {

std::vector<Example> FindExamples() {
  std::vector<Example> examples;
  std::error_code error;
  for (const Shipped& one : kShipped) {
    const std::string path = PathOfExample(one.name);
    if (fs::exists(path, error)) examples.push_back({one.title, path});
  }
  return examples;
}

}  // namespace

const std::vector<Example>& Examples() {
  static const std::vector<Example> examples = FindExamples();
  return examples;
}

}  // namespace coppice::editor
