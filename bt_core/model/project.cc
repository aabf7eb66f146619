// Files are read in the order in which they are named, each once, however often it is included; a
// circle of includes ends there. All problems of all files are collected before anything is
// refused: who mends a file wants to see them together.
#include "bt_core/model/project.h"

#include <sys/stat.h>

#include <map>
#include <set>
#include <utility>

#include "bt_core/model/upgrade.h"

namespace coppice {
namespace {

constexpr int kMaxIncludeDepth = 100;  // reading goes that deep on the stack
constexpr int kMaxMissingPackages = 16;

// The same for two names of one file.
std::string IdentityOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return path;  // a text that never was a file
  return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
}

std::string LineOf(const Document& document, ElementIndex element) {
  const SourceLocation where = document.Location(document.element(element).offset);
  return where.file + ":" + std::to_string(where.line);
}

template <class Map>
const typename Map::mapped_type* FindIn(const Map& map, std::string_view id) {
  const auto found = map.find(id);
  return found == map.end() ? nullptr : &found->second;
}

}  // namespace

// Fills a Project. Documents are named by number, never by reference: an include adds documents.
class ProjectReader {
 public:
  explicit ProjectReader(const PackageFinder& find_package, const DocumentReader& read = {})
      : find_package_(find_package ? find_package : PackageFinder(FindRosPackage)),
        read_(read ? read : DocumentReader(Document::FromFile)) {}

  void ReadFile(const std::string& path) {
    if (IsKnown(path)) return;
    if (auto document = read_(path, diagnostics_)) Add(*std::move(document));
  }

  /// Reads it as one that the user has given: it may name the main tree.
  void ReadGiven(const std::string& path) {
    const auto number = static_cast<std::uint32_t>(project_.documents_.size());
    ReadFile(path);
    if (number < project_.documents_.size()) given_.push_back(number);
  }

  void ReadText(std::string text, const std::string& file) {
    given_.push_back(0);
    auto document = Document::FromText(std::move(text), file, diagnostics_);
    if (document) Add(*std::move(document));
  }

  std::optional<Project> Finish(Diagnostics& diagnostics) {
    diagnostics.Append(diagnostics_);
    if (project_.documents_.empty()) return std::nullopt;
    if (project_.documents_.size() > 1) UpgradeTreesByTheirNames();
    ChooseMainTree();
    project_.has_errors_ = diagnostics_.has_errors();
    return std::move(project_);
  }

 private:
  // Format 3 becomes format 4 here; Location() still names the user's own text.
  Document AsFormat4(std::uint32_t number, Document document) {
    project_.was_format_3_.push_back(false);
    if (document.element(kRootElement).tag != "root") return document;
    const std::size_t told = diagnostics_.all().size();
    const Edit edit = UpgradeToFormat4(document, diagnostics_);
    if (edit.empty()) return document;
    project_.was_format_3_.back() = true;
    const bool told_of_format_3 = diagnostics_.all().size() > told;
    Diagnostics known;  // the same warnings once more
    std::optional<Document> upgraded = document.Rewritten(edit, known);
    if (!upgraded) return document;
    of_format_3_.emplace(number, document);
    const bool says_so =
        document.FindAttribute(document.element(kRootElement), "BTCPP_format") != nullptr;
    if (says_so || told_of_format_3 || edit.size() > 1) {
      diagnostics_.Warning(document.Location(document.element(kRootElement).offset),
                           "format 3 is read as format 4",
                           "\"coppice upgrade -i " + document.file() + "\" makes it format 4",
                           {ProblemKind::kOldFormat, ""});
    } else {
      WarnOfNoFormat(document);
    }
    return *std::move(upgraded);
  }

  // What a document of format 3 uses as a node type may be a tree of a file that was read after it.
  // That adds and moves no element, so their numbers stay.
  void UpgradeTreesByTheirNames() {
    const TreeNames names = project_.TreesUsedByName();
    for (const auto& [number, document] : of_format_3_) {
      Diagnostics known;
      auto upgraded = document.Rewritten(UpgradeToFormat4(document, known, names), known);
      if (upgraded) project_.documents_[number] = *std::move(upgraded);
    }
  }

  void WarnOfNoFormat(const Document& document) {
    diagnostics_.Warning(document.Location(document.element(kRootElement).offset),
                         "no BTCPP_format; read as format 4", "", {ProblemKind::kOldFormat, ""});
  }

  void Add(Document document) {
    const auto number = static_cast<std::uint32_t>(project_.documents_.size());
    known_.insert(IdentityOf(document.file()));
    project_.documents_.push_back(AsFormat4(number, std::move(document)));
    if (!CheckRoot(number)) return;
    for (ElementIndex i = At(number).element(kRootElement).first_child; i != kNoElement;) {
      const Element element = At(number).element(i);
      if (element.tag == "BehaviorTree") {
        AddTree(number, i);
      } else if (element.tag == "include") {
        Include(number, element);
      } else if (element.tag == "TreeNodesModel") {
        AddModels(number, element);
      } else {
        ReportForeign(number, element);
      }
      i = element.next_sibling;
    }
  }

  // Other programs keep their own data below <root>. What is nearly a known name is misspelt.
  void ReportForeign(std::uint32_t number, const Element& element) {
    const std::string tag(element.tag);
    const std::string hint = DidYouMean(tag, {"BehaviorTree", "include", "TreeNodesModel"});
    if (!hint.empty()) return Error(number, element, "unexpected <" + tag + "> below <root>", hint);
    diagnostics_.Warning(At(number).Location(element.offset),
                         "<" + tag + "> below <root> is ignored");
  }

  const Document& At(std::uint32_t number) const { return project_.documents_[number]; }

  bool IsKnown(const std::string& path) const { return known_.count(IdentityOf(path)) > 0; }

  // A package is looked for once: that may take a walk through the disk. Who names very many that
  // there are not means nothing else by it.
  std::string FolderOf(const std::string& package) {
    const auto known = packages_.find(package);
    if (known != packages_.end()) return known->second;
    if (missing_packages_ == kMaxMissingPackages) return {};
    std::string folder = find_package_(package);
    if (folder.empty()) ++missing_packages_;
    return packages_[package] = std::move(folder);
  }

  void Include(std::uint32_t number, const Element& element) {
    const auto find = [this](const std::string& package) { return FolderOf(package); };
    const std::string path = IncludePath(At(number), element, find, diagnostics_);
    if (path.empty()) return;
    if (depth_ == kMaxIncludeDepth) {
      return Error(
          number, element,
          "files include each other more than " + std::to_string(kMaxIncludeDepth) + " deep");
    }
    ++depth_;
    ReadFile(path);
    --depth_;
  }

  // False if nothing below can be meant as a tree.
  bool CheckRoot(std::uint32_t number) {
    const Element root = At(number).element(kRootElement);
    if (root.tag != "root") {
      Error(number, root, "root element is <" + std::string(root.tag) + ">",
            "expected <root BTCPP_format=\"4\">");
      return root.tag == "Root";
    }
    const Attribute* format = At(number).FindAttribute(root, "BTCPP_format");
    if (!format) {
      WarnOfNoFormat(At(number));
    } else if (format->value != "4") {
      diagnostics_.Error(At(number).Location(format->value_offset),
                         "BTCPP_format=\"" + std::string(format->value) + "\" is not known",
                         "expected BTCPP_format=\"4\"");
      return false;
    }
    return true;
  }

  void AddTree(std::uint32_t number, ElementIndex index) {
    const Element element = At(number).element(index);
    std::string id(At(number).AttributeValue(element, "ID"));
    if (id.empty() && !IsOnlyTree(number, index)) {
      Error(number, element, "<BehaviorTree> without ID", "only a file's sole tree needs none");
      return;
    }
    if (id.empty()) id = "BehaviorTree_" + std::to_string(trees_without_id_++);
    if (element.child_count != 1) {
      const bool is_empty = element.child_count == 0;
      Error(number, element,
            "tree \"" + id + "\" has " + std::to_string(element.child_count) +
                " root nodes, expected exactly 1",
            {}, is_empty ? ProblemSubject{ProblemKind::kEmptyTree, id} : ProblemSubject{});
      if (is_empty) return;
    }
    const auto [at, inserted] = project_.trees_.insert({id, TreeDefinition{number, index}});
    if (inserted) return;
    Error(number, element, "tree \"" + id + "\" is defined twice",
          "first defined at " + LineOf(At(at->second.document), at->second.element));
  }

  bool IsOnlyTree(std::uint32_t number, ElementIndex tree) const {
    const Document& document = At(number);
    for (ElementIndex i = document.element(kRootElement).first_child; i != kNoElement;
         i = document.element(i).next_sibling) {
      if (i != tree && document.element(i).tag == "BehaviorTree") return false;
    }
    return true;
  }

  void AddModels(std::uint32_t number, const Element& element) {
    for (NodeModel& model : ReadModels(At(number), element, number, diagnostics_)) {
      NodeModelMap& models =
          model.category == NodeCategory::kSubTree ? project_.subtree_models_ : project_.models_;
      const auto [at, inserted] = models.try_emplace(model.id, model);
      if (inserted || HasSameInterface(at->second, model)) continue;
      diagnostics_.Warning(
          At(number).Location(At(number).element(model.element).offset),
          "another model of \"" + model.id + "\" with other ports is ignored",
          "the first one is at " + LineOf(At(at->second.document), at->second.element));
    }
  }

  void ChooseMainTree() {
    for (const std::uint32_t number : given_) {
      project_.main_tree_ =
          At(number).AttributeValue(At(number).element(kRootElement), "main_tree_to_execute");
      if (!project_.main_tree_.empty()) return;
    }
    int trees_in_first = 0;
    std::string only;
    for (const auto& [id, definition] : project_.trees_) {
      if (definition.document != 0) continue;
      ++trees_in_first;
      only = id;
    }
    if (trees_in_first == 1) project_.main_tree_ = only;
  }

  void Error(std::uint32_t number, const Element& element, std::string message,
             std::string hint = {}, ProblemSubject about = {}) {
    diagnostics_.Error(At(number).Location(element.offset), std::move(message), std::move(hint),
                       std::move(about));
  }

  Project project_;
  Diagnostics diagnostics_;
  const PackageFinder find_package_;
  std::map<std::string, std::string> packages_;  // their folders by name; empty: there is none
  int missing_packages_ = 0;
  DocumentReader read_;
  std::vector<std::uint32_t> given_;
  std::set<std::string> known_;                    // identities of all documents
  std::map<std::uint32_t, Document> of_format_3_;  // as they were
  int depth_ = 0;                                  // of the include that is read
  int trees_without_id_ = 0;
};

std::optional<Project> Project::FromFile(const std::string& path, Diagnostics& diagnostics,
                                         const PackageFinder& find_package) {
  return FromFiles({path}, diagnostics, find_package);
}

std::optional<Project> Project::FromFiles(const std::vector<std::string>& paths,
                                          Diagnostics& diagnostics,
                                          const PackageFinder& find_package,
                                          const DocumentReader& read) {
  ProjectReader reader(find_package, read);
  for (const std::string& path : paths) reader.ReadGiven(path);
  return reader.Finish(diagnostics);
}

std::optional<Project> Project::FromText(std::string text, const std::string& file,
                                         Diagnostics& diagnostics,
                                         const PackageFinder& find_package) {
  ProjectReader reader(find_package);
  reader.ReadText(std::move(text), file);
  return reader.Finish(diagnostics);
}

const TreeDefinition* Project::Find(std::string_view id) const { return FindIn(trees_, id); }

std::set<std::string, std::less<>> Project::TreesUsedByName() const {
  std::set<std::string, std::less<>> names;
  for (const auto& [id, tree] : trees_) {
    if (!FindIn(models_, id)) names.insert(id);
  }
  return names;
}

const NodeModel* Project::SubTreeModel(std::string_view id) const {
  return FindIn(subtree_models_, id);
}

}  // namespace coppice
