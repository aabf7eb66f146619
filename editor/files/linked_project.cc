#include "editor/files/linked_project.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

namespace coppice::editor {
namespace {

DocumentReader ReaderOf(OpenProject& files) {
  return [&files](const std::string& path, Diagnostics& diagnostics) -> std::optional<Document> {
    const EditedFile* const edited = files.Open(path, diagnostics);
    if (!edited) return std::nullopt;
    diagnostics.Append(edited->problems);
    return edited->document;
  };
}

std::ptrdiff_t ErrorsIn(const Diagnostics& diagnostics) {
  return std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                       [](const Diagnostic& one) { return one.severity == Severity::kError; });
}

std::vector<std::string_view> TreesIn(const Document& document) {
  std::vector<std::string_view> ids;
  for (ElementIndex i = document.element(kRootElement).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    const Element& element = document.element(i);
    if (element.tag == "BehaviorTree") ids.push_back(document.AttributeValue(element, "ID"));
  }
  return ids;
}

// Those that are open beside a file, by the IDs of their trees.
class OtherFiles {
 public:
  OtherFiles(const OpenProject& files, const std::string& path) : folder_(ProjectFolder(path)) {
    for (const auto& [other, file] : files.files()) {
      if (!file.document || other == path) continue;
      for (const std::string_view id : TreesIn(*file.document)) owners_.emplace(id, &file);
    }
  }

  // The next one that has a tree which is missing, and none that is there already; empty: there is
  // none.
  std::string Next(const Project& project) {
    for (const std::string& id : MissingTrees(project)) {
      const auto [begin, end] = owners_.equal_range(id);
      for (auto at = begin; at != end; ++at) {
        const EditedFile& file = *at->second;
        if (!tried_.insert(&file).second || ProjectFolder(file.path) != folder_) continue;
        const std::vector<std::string_view> ids = TreesIn(*file.document);
        const bool would_come_twice = std::any_of(
            ids.begin(), ids.end(), [&](std::string_view one) { return project.Find(one); });
        if (!would_come_twice) return file.path;
      }
    }
    return {};
  }

 private:
  const std::string folder_;
  std::multimap<std::string, const EditedFile*, std::less<>> owners_;
  std::set<const EditedFile*> tried_;
};

}  // namespace

std::optional<LinkedProject> ReadLinked(OpenProject& files, const std::string& path,
                                        Diagnostics& diagnostics) {
  const DocumentReader read = ReaderOf(files);
  Diagnostics own_problems;
  std::optional<Project> own = Project::FromFiles({path}, own_problems, {}, read);
  diagnostics.Append(own_problems);
  if (!own) return std::nullopt;
  const std::size_t own_documents = own->documents().size();
  LinkedProject linked{*std::move(own), own_documents, ""};
  linked.main_tree = linked.project.main_tree();
  if (MissingTrees(linked.project).empty()) return linked;
  std::vector<std::string> paths = {path};
  OtherFiles others(files, path);
  for (std::string next = others.Next(linked.project); !next.empty();
       next = others.Next(linked.project)) {
    paths.push_back(next);
    Diagnostics problems;
    std::optional<Project> more = Project::FromFiles(paths, problems, {}, read);
    if (more && ErrorsIn(problems) == ErrorsIn(own_problems)) {
      linked.project = *std::move(more);
    } else {
      paths.pop_back();
    }
  }
  return linked;
}

std::optional<Project> ReadOpenProject(OpenProject& files, const std::string& path,
                                       Diagnostics& diagnostics) {
  return Project::FromFiles({path}, diagnostics, {}, ReaderOf(files));
}

std::set<std::string> MissingTrees(const Project& project) {
  std::set<std::string> missing;
  for (const Document& document : project.documents()) {
    for (const Element& element : document.elements()) {
      if (element.tag != "SubTree") continue;
      const std::string_view id = document.AttributeValue(element, "ID");
      if (!project.Find(id)) missing.emplace(id);
    }
  }
  return missing;
}

std::string ProjectFolder(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path own = fs::absolute(file, error).lexically_normal().parent_path();
  for (fs::path folder = own; folder != folder.root_path(); folder = folder.parent_path()) {
    if (fs::exists(folder / ".git", error)) return folder.string();
  }
  return own.string();
}

}  // namespace coppice::editor
