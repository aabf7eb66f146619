// What is open: files, runs (of robots and of records), and the one tree that is shown. Knows
// nothing of windows and colours.
#ifndef COPPICE_EDITOR_WORKSPACE_WORKSPACE_H_
#define COPPICE_EDITOR_WORKSPACE_WORKSPACE_H_

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/canvas/tree_view.h"
#include "editor/files/open_project.h"
#include "editor/live/kept_marks.h"
#include "editor/live/run_view.h"
#include "editor/scene/node_models.h"
#include "editor/timeline/bookmarks.h"

namespace coppice::editor {

struct OpenFile {
  std::string path;
  std::shared_ptr<const Forest> forest;
  std::shared_ptr<const NodeModels> models;
  std::vector<Diagnostic> problems;       ///< of reading, then of checking
  std::vector<Diagnostic> read_problems;  ///< of reading alone
  std::string text;                       ///< of a file that cannot be parsed; else empty
  bool is_stale = false;                  ///< the text is malformed; forest is what it was before
};

/// An element of a file that is being edited.
struct ElementPlace {
  std::string path;
  ElementIndex element{0};
};

/// Nodes of a tree whose children are hidden, as TreeView::ClosedNodes.
struct ClosedNodes {
  std::string path;  ///< of the file
  std::string tree;  ///< ID
  std::vector<std::string> nodes;
};

class Workspace {
 public:
  explicit Workspace(TreeView::SizeOf size_of) : size_of_(std::move(size_of)) {}

  /// Opens a file of trees, or reads it again if it is open, and shows its main tree; or a record.
  /// False if there is nothing to show; the problems tell why.
  bool Open(const std::string& path, double now);
  /// Opens a file beside what is shown; not if it is open.
  void OpenBehind(const std::string& path, double now);
  /// Makes a file that is not on the disk yet, with one empty tree, and shows it. Returns its path,
  /// which is free in this folder.
  std::string New(double now);
  /// The same with a path that no open file has.
  void Create(const std::string& path, double now);
  /// Adds node models from a file; what is wrong goes to the problems.
  void AddModels(const std::string& path);
  /// The files that were added so.
  std::vector<std::string> model_files() const;
  /// Shows all files with what is known of node types now.
  void RenewAll(double now);
  /// Looks at the disk at once; Update does it every second.
  void Reload(double now);

  /// The files as they are being edited. After a change call Refresh.
  OpenProject& project() { return project_; }
  const OpenProject& project() const { return project_; }

  /// Shows what has changed in project() since the last time. The checker follows a little later.
  void Refresh(double now);
  /// The file has another path from now on.
  void Rename(const std::string& path, const std::string& new_path);

  /// The first one is shown.
  void AddRun(std::unique_ptr<RunSource> source);
  /// Takes leave of the robot, or forgets the record.
  void CloseRun(std::size_t run, double now);
  /// The number of the run of that name, or -1.
  int FindRun(const std::string& name) const;

  /// Takes in what has come of all runs, looks at the disk, checks what was changed. Once per
  /// frame. False if nothing of that is to be seen.
  bool Update(double now);
  /// What the last Updates found on the disk that the user should know; empty: nothing.
  std::string TakeNews() { return std::exchange(news_, {}); }
  /// Seconds until Update has something to do for files; infinity: nothing.
  double NextUpdateIn(double now) const;
  /// Checks what waits to be checked.
  void CheckNow();

  void ShowFileTree(std::size_t file, int tree, double now);
  void ShowRun(std::size_t run);
  /// The next run, from a file too; without runs nothing changes.
  void ShowNextRun();

  /// Trees of files with closed nodes.
  std::vector<ClosedNodes> closed() const;
  /// Closes these nodes when the tree is shown for the first time.
  void CloseAtFirst(const std::string& path, const std::string& tree,
                    std::vector<std::string> nodes);

  const std::vector<OpenFile>& files() const { return files_; }
  const std::vector<std::unique_ptr<RunView>>& runs() const { return runs_; }
  const std::vector<Diagnostic>& model_problems() const { return model_problems_; }
  /// Why records could not be opened.
  const std::vector<Diagnostic>& record_problems() const { return record_problems_; }

  /// Breakpoints and faults, of all robots.
  HookList hooks;
  LogPoints log_points;
  /// By RunView::bookmark_name.
  Bookmarks bookmarks;
  LanePins pins;
  /// All of these.
  Marks marks() { return {hooks, log_points, bookmarks, pins}; }

  /// The tree that is shown, null if there is none. Its scene is not empty.
  TreeView* view() { return view_; }
  const Forest* forest() const;
  /// The run that is shown, null if it is a file.
  RunView* run() { return run_ < 0 ? nullptr : runs_[Index(run_)].get(); }
  const RunView* run() const { return run_ < 0 ? nullptr : runs_[Index(run_)].get(); }
  /// How the shown tree stands, null if it is that of a file.
  const TreeSnapshot* tree_state() const { return run() ? &run()->state() : nullptr; }
  const OpenFile* file() const { return file_ < 0 ? nullptr : &files_[Index(file_)]; }
  int tree() const { return tree_; }  ///< of forest(); -1: none

  /// Every tree is laid out this way from now on.
  void SetStyle(const LayoutStyle& style, double now);
  const LayoutStyle& style() const { return style_; }
  /// Nodes have other sizes than when they were shown: the fonts have changed.
  void MeasureAgain(double now);
  const TreeView::SizeOf& size_of() const { return size_of_; }

  /// The element of project() that the scene node stands for; nothing in a run and in a file
  /// whose text is malformed.
  std::optional<ElementPlace> PlaceOf(const SceneNode& node) const;
  /// The <BehaviorTree> that is shown.
  std::optional<ElementPlace> ShownTree() const;
  std::string ShownTreeId() const;
  /// The shown tree is of a file of format 3 that has other elements in format 4, so that its nodes
  /// stand for none of project().
  bool IsOfOtherElements() const;

  /// Selects these elements, by offset, in the shown tree or else in the one that has the first.
  void SelectPlaces(const std::vector<FilePlace>& places, double now);

  /// Selects the element with that number in that document, if the shown tree has it.
  bool SelectElement(const Document& document, ElementIndex element);

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  struct ScenePointsInto {
    std::shared_ptr<const void> trees;
    std::shared_ptr<const void> models;
  };
  static std::size_t Index(int number) { return static_cast<std::size_t>(number); }
  void Add(const std::string& path, double now);
  OpenFile Load(const std::string& path);
  void Renew(std::size_t file);
  void LoadAll(double now);
  void CheckAll();
  void LookAtDisk(double now);
  void RefreshRecords(double now);
  void RemoveReachedStops();
  void LearnFromRuns(double now);
  bool IsInShownTree(const FilePlace& place) const;
  bool ShowTreeOf(const FilePlace& place, double now);
  std::vector<std::uint32_t> NodesAt(const std::vector<FilePlace>& places) const;
  bool OpenRecord(const std::string& path);
  void ShowTreeOfRun(double now);
  TreeView* ViewOf(const std::string& key, const Forest& forest, int tree, const NodeModels& models,
                   double now, bool renew);

  TreeView::SizeOf size_of_;
  OpenProject project_;
  std::uint64_t shown_version_ = 0;  // of project_
  std::string news_;
  double check_at_ = kNever;
  double look_at_ = kNever;
  double refresh_at_ = kNever;
  std::vector<OpenFile> files_;
  std::vector<std::unique_ptr<RunView>> runs_;
  NodeModels models_;                    // known for all files
  std::vector<Project> model_projects_;  // the same, for the checker
  std::vector<Diagnostic> model_problems_;
  std::vector<Project> run_models_;           // what the robots say about node types
  std::vector<const RunTree*> learned_from_;  // the trees that said it; never followed
  std::vector<Diagnostic> record_problems_;
  std::map<std::string, std::unique_ptr<TreeView>> views_;
  std::map<const TreeView*, ScenePointsInto> alive_;
  std::map<std::string, std::vector<std::string>> closed_;  // by key of the view, for CloseAtFirst
  LayoutStyle style_;
  TreeView* view_ = nullptr;
  int file_ = -1;
  int run_ = -1;
  int tree_ = -1;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_WORKSPACE_H_
