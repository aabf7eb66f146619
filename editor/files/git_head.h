// What git has of the files that are open: their texts in the commit HEAD. Without git, or for a
// file that git does not know, there is nothing. git is asked by a thread of its own.
//
//   GitHead git(wake);
//   std::shared_ptr<const std::string> text = git.TextOf(path);   // at once; null until it is
//   known
#ifndef COPPICE_EDITOR_FILES_GIT_HEAD_H_
#define COPPICE_EDITOR_FILES_GIT_HEAD_H_

#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coppice::editor {

class GitHead {
 public:
  /// `wake` is called by a thread when there is news.
  explicit GitHead(std::function<void()> wake = {}) : wake_(std::move(wake)) {}

  /// The text that the file has in HEAD, or null. Asks git the first time, and again when Look has
  /// seen another HEAD.
  std::shared_ptr<const std::string> TextOf(const std::string& path);

  /// Looks whether there was a commit or a checkout since; costs a look at one file for each
  /// folder.
  void Look();

  /// Waits for what git was asked. For tests, and for pictures that are to be complete.
  void Wait();

 private:
  struct Answer {
    std::shared_ptr<const std::string> text;
    std::string log;  ///< of HEAD: git writes it whenever HEAD moves
  };
  struct Known {
    std::future<Answer> coming;
    Answer answer;
    std::filesystem::file_time_type log_time;
  };

  static Answer Ask(const std::string& path);
  void Start(const std::string& path, Known& known);
  void Take(Known& known);

  std::function<void()> wake_;
  std::map<std::string, Known> files_;
};

/// What a program wrote to its standard output; nothing if it cannot be run or ends with an error.
/// Its standard error goes nowhere.
std::optional<std::string> OutputOf(const std::vector<std::string>& command);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_GIT_HEAD_H_
