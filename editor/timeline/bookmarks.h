// Places in runs that the user has marked, with a few words.
#ifndef COPPICE_EDITOR_TIMELINE_BOOKMARKS_H_
#define COPPICE_EDITOR_TIMELINE_BOOKMARKS_H_

#include <cstddef>
#include <map>
#include <string>

namespace coppice::editor {

class Bookmarks {
 public:
  /// By tick of the run (run.h).
  using OfRun = std::map<std::size_t, std::string>;

  /// Those of the run of that name.
  const OfRun& Of(const std::string& run) const;

  void Set(const std::string& run, std::size_t tick, std::string text) {
    runs_[run][tick] = std::move(text);
  }
  void Remove(const std::string& run, std::size_t tick);

  /// The bookmark behind or before a tick; null if there is none.
  const OfRun::value_type* Next(const std::string& run, std::size_t tick) const;
  const OfRun::value_type* Before(const std::string& run, std::size_t tick) const;

  const std::map<std::string, OfRun>& all() const { return runs_; }

 private:
  std::map<std::string, OfRun> runs_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_BOOKMARKS_H_
