#include "editor/files/linked_project.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

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

bool HasTree(const Document& document, std::string_view id) {
  for (ElementIndex i = document.element(kRootElement).first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    const Element& element = document.element(i);
    if (element.tag == "BehaviorTree" && document.AttributeValue(element, "ID") == id) return true;
  }
  return false;
}

std::ptrdiff_t ErrorsIn(const Diagnostics& diagnostics) {
  return std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                       [](const Diagnostic& one) { return one.severity == Severity::kError; });
}

// Those that are open beside a file.
class OtherFiles {
 public:
  OtherFiles(const OpenProject& files, const std::string& path)
      : files_(files), folder_(ProjectFolder(path)), tried_{path} {}

  // The next one that has a tree which is missing; empty: there is none.
  std::string Next(const Project& project) {
    for (const std::string& id : MissingTrees(project)) {
      for (const auto& [path, file] : files_.files()) {
        if (!file.document || tried_.count(path) > 0 || !HasTree(*file.document, id)) continue;
        tried_.insert(path);
        if (ProjectFolder(path) == folder_) return path;
      }
    }
    return {};
  }

 private:
  const OpenProject& files_;
  const std::string folder_;
  std::set<std::string> tried_;
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

std::vector<std::string> MissingTrees(const Project& project) {
  std::vector<std::string> missing;
  for (const Document& document : project.documents()) {
    for (const Element& element : document.elements()) {
      if (element.tag != "SubTree") continue;
      const std::string_view id = document.AttributeValue(element, "ID");
      if (project.Find(id) || std::count(missing.begin(), missing.end(), id) > 0) continue;
      missing.emplace_back(id);
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
