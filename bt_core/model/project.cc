#include "bt_core/model/project.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace coppice {
namespace {

bool SameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return a == b || std::filesystem::equivalent(a, b, error);
}

}  // namespace

std::optional<Project> Project::FromFile(const std::string& path, Diagnostics& diagnostics,
                                         const PackageFinder& find_package) {
  std::optional<Document> document = Document::FromFile(path, diagnostics);
  if (!document) return std::nullopt;
  Project project;
  project.Add(*std::move(document), diagnostics, find_package);
  if (diagnostics.has_errors()) return std::nullopt;
  project.ChooseMainTree();
  return project;
}

std::optional<Project> Project::FromText(std::string text, const std::string& file,
                                         Diagnostics& diagnostics,
                                         const PackageFinder& find_package) {
  std::optional<Document> document = Document::FromText(std::move(text), file, diagnostics);
  if (!document) return std::nullopt;
  Project project;
  project.Add(*std::move(document), diagnostics, find_package);
  if (diagnostics.has_errors()) return std::nullopt;
  project.ChooseMainTree();
  return project;
}

const TreeDefinition* Project::Find(std::string_view id) const {
  const auto found = trees_.find(id);
  return found == trees_.end() ? nullptr : &found->second;
}

void Project::Add(Document document, Diagnostics& diagnostics, const PackageFinder& find_package) {
  const auto number = static_cast<std::uint32_t>(documents_.size());
  documents_.push_back(std::move(document));
  // By index, never by reference: an include adds documents.
  const Element root = documents_[number].element(0);
  const auto where = [&](const Element& element) {
    return documents_[number].Location(element.offset);
  };
  if (root.tag != "root") {
    diagnostics.Error(where(root), "root element is <" + std::string(root.tag) + ">",
                      "expected <root BTCPP_format=\"4\">");
    return;
  }
  const std::string format(documents_[number].AttributeValue(root, "BTCPP_format"));
  if (format.empty()) {
    diagnostics.Warning(where(root), "no BTCPP_format; read as format 4");
  } else if (format != "4") {
    diagnostics.Error(where(root), "BTCPP_format=\"" + format + "\" is not known",
                      "expected BTCPP_format=\"4\"");
    return;
  }
  for (ElementIndex i = root.first_child; i != kNoElement;) {
    const Element element = documents_[number].element(i);
    if (element.tag == "BehaviorTree") {
      AddTree(number, i, diagnostics);
    } else if (element.tag == "include") {
      Include(number, i, diagnostics, find_package);
    } else if (element.tag != "TreeNodesModel") {
      const std::string tag(element.tag);
      diagnostics.Error(where(element), "unexpected <" + tag + "> below <root>",
                        DidYouMean(tag, {"BehaviorTree", "include", "TreeNodesModel"}));
    }
    i = element.next_sibling;
  }
}

void Project::AddTree(std::uint32_t document, ElementIndex index, Diagnostics& diagnostics) {
  const Document& doc = documents_[document];
  const Element& element = doc.element(index);
  const SourceLocation where = doc.Location(element.offset);
  const std::string id(doc.AttributeValue(element, "ID"));
  if (id.empty()) {
    diagnostics.Error(where, "<BehaviorTree> without ID");
    return;
  }
  if (element.child_count != 1) {
    diagnostics.Error(where, "tree \"" + id + "\" has " + std::to_string(element.child_count) +
                                 " root nodes, expected exactly 1");
    return;
  }
  const auto [at, inserted] = trees_.insert({id, TreeDefinition{document, index}});
  if (!inserted) {
    const Document& first = documents_[at->second.document];
    const SourceLocation other = first.Location(first.element(at->second.element).offset);
    diagnostics.Error(where, "tree \"" + id + "\" is defined twice",
                      "first defined at " + other.file + ":" + std::to_string(other.line));
  }
}

void Project::Include(std::uint32_t document, ElementIndex index, Diagnostics& diagnostics,
                      const PackageFinder& find_package) {
  const Document& doc = documents_[document];
  const Element& element = doc.element(index);
  const SourceLocation where = doc.Location(element.offset);
  std::filesystem::path path(doc.AttributeValue(element, "path"));
  if (path.empty()) {
    diagnostics.Error(where, "<include> without path");
    return;
  }
  std::filesystem::path folder = std::filesystem::path(doc.file()).parent_path();
  if (const Attribute* package = doc.FindAttribute(element, "ros_pkg")) {
    const std::string name(package->value);
    folder = find_package ? find_package(name) : std::string();
    if (folder.empty()) {
      diagnostics.Error(where, "ROS package \"" + name + "\" was not found",
                        "looked in ROS_PACKAGE_PATH");
      return;
    }
  }
  if (path.is_relative()) path = folder / path;
  const std::string file = path.lexically_normal().string();
  const bool known = std::any_of(documents_.begin(), documents_.end(),
                                 [&](const Document& d) { return SameFile(d.file(), file); });
  if (known) return;
  if (!std::filesystem::is_regular_file(path)) {
    diagnostics.Error(where, "included file " + file + " does not exist");
    return;
  }
  if (auto included = Document::FromFile(file, diagnostics)) {
    Add(*std::move(included), diagnostics, find_package);
  }
}

void Project::ChooseMainTree() {
  const Document& first = documents_.front();
  main_tree_ = first.AttributeValue(first.element(0), "main_tree_to_execute");
  if (!main_tree_.empty()) return;
  int trees_in_first = 0;
  std::string only;
  for (const auto& [id, definition] : trees_) {
    if (definition.document != 0) continue;
    ++trees_in_first;
    only = id;
  }
  if (trees_in_first == 1) main_tree_ = only;
}

}  // namespace coppice
