#include "bt_core/engine/program.h"

namespace coppice {

namespace {

std::string IdOf(const StartTag& tag) {
  return CategoryFromTag(tag.name) ? std::string(tag.Value("ID")) : tag.name;
}

}  // namespace

const SourceText& Program::TextOf(NodeIndex node) const {
  return texts[trees[info[node].scope].document];
}

StartTag Program::TagOf(NodeIndex node) const { return TextOf(node).StartTagAt(info[node].offset); }

std::string Program::Id(NodeIndex node) const { return IdOf(TagOf(node)); }

std::string Program::Name(NodeIndex node) const {
  const StartTag tag = TagOf(node);
  const std::string_view name = tag.Value("name");
  return name.empty() ? IdOf(tag) : std::string(name);
}

std::string Program::Path(NodeIndex node) const {
  const std::string& instance = trees[info[node].scope].path;
  const StartTag tag = TagOf(node);
  const std::string_view name = tag.Value("name");
  const std::string own =
      name.empty() ? IdOf(tag) + "::" + std::to_string(node + 1) : std::string(name);
  return instance.empty() ? own : instance + "/" + own;
}

SourceLocation Program::Location(NodeIndex node) const {
  return TextOf(node).Location(info[node].offset);
}

std::uint32_t Program::FirstPort(NodeIndex node) const {
  const NodeRecord& record = nodes[node];
  const bool of_user = record.type == NodeType::kLeaf || record.type == NodeType::kUser;
  return of_user ? leaves[record.first_port].first_port : record.first_port;
}

}  // namespace coppice
