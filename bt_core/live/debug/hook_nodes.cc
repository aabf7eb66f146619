#include "bt_core/live/debug/hook_nodes.h"

namespace coppice {
namespace {

// The path as nodes bear it: without the ID of the main tree in front.
std::string_view WithoutMain(const Program& program, std::string_view path) {
  const std::string& main = program.trees[0].id;
  const bool has_main =
      path.size() > main.size() && path.substr(0, main.size()) == main && path[main.size()] == '/';
  return has_main ? path.substr(main.size() + 1) : path;
}

// "instance/ID" for "instance/ID::7" or "instance/name".
std::string PathOfType(const Program& program, NodeIndex node) {
  const std::string& instance = program.trees[program.info[node].scope].path;
  return instance.empty() ? program.Id(node) : instance + "/" + program.Id(node);
}

std::vector<NodeIndex> FindExactly(const Program& program, std::string_view path) {
  std::vector<NodeIndex> nodes;
  for (NodeIndex i{0}; i < program.nodes.size(); ++i) {
    if (program.Path(i) == path) nodes.push_back(i);
  }
  if (!nodes.empty()) return nodes;
  for (NodeIndex i{0}; i < program.nodes.size(); ++i) {
    if (PathOfType(program, i) == path) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace

std::vector<NodeIndex> FindNodes(const Program& program, std::string_view path) {
  std::vector<NodeIndex> nodes = FindExactly(program, path);
  const std::string_view inner = WithoutMain(program, path);
  return nodes.empty() && inner.size() != path.size() ? FindExactly(program, inner) : nodes;
}

std::string DescribeMissingNode(const Program& program, std::string_view path) {
  std::vector<std::string> paths;
  paths.reserve(program.nodes.size());
  for (NodeIndex i{0}; i < program.nodes.size(); ++i) paths.push_back(program.Path(i));
  const std::string hint = DidYouMean(path, paths);
  return "no node \"" + std::string(path) + "\" in the present tree" +
         (hint.empty() ? "" : " (" + hint + ")");
}

}  // namespace coppice
