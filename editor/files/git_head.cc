#include "editor/files/git_head.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <system_error>
#include <utility>
#include <vector>

extern char** environ;

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

std::string WithoutLineEnd(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

std::string ReadAll(int from) {
  std::string all;
  std::array<char, 65536> piece;
  for (ssize_t got; (got = ::read(from, piece.data(), piece.size())) > 0;) {
    all.append(piece.data(), static_cast<std::size_t>(got));
  }
  return all;
}

}  // namespace

std::optional<std::string> OutputOf(const std::vector<std::string>& command) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 1);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  std::string output = failed ? "" : ReadAll(ends[0]);
  ::close(ends[0]);
  int status = 0;
  if (failed || ::waitpid(child, &status, 0) != child) return std::nullopt;
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return good ? std::optional(std::move(output)) : std::nullopt;
}

// The folder may be a stranger's, who can have written into its configuration what git runs: for
// objects that are missing, or to show a commit. So nothing is fetched, and only a file is asked
// for.
GitHead::Answer GitHead::Ask(const std::string& path) {
  const fs::path file(path);
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  Answer answer;
  const auto log = OutputOf({"git", "-C", folder, "rev-parse", "--git-path", "logs/HEAD"});
  if (!log) return answer;
  const fs::path log_path(WithoutLineEnd(*log));
  answer.log = (log_path.is_absolute() ? log_path : fs::path(folder) / log_path).string();
  const std::string name = "HEAD:./" + file.filename().string();
  if (auto text =
          OutputOf({"git", "-C", folder, "-c", "protocol.allow=never", "cat-file", "blob", name})) {
    answer.text = std::make_shared<const std::string>(*std::move(text));
  }
  return answer;
}

void GitHead::Start(const std::string& path, Known& known) {
  try {
    known.coming = std::async(std::launch::async, [path, wake = wake_] {
      Answer answer = Ask(path);
      if (wake) wake();
      return answer;
    });
  } catch (const std::system_error&) {
    known.coming = {};  // no threads here: no git
  }
}

void GitHead::Take(Known& known) {
  known.answer = known.coming.get();
  std::error_code error;
  known.log_time = fs::last_write_time(known.answer.log, error);
}

std::shared_ptr<const std::string> GitHead::TextOf(const std::string& path) {
  const auto [at, is_new] = files_.try_emplace(path);
  Known& known = at->second;
  if (is_new) Start(path, known);
  const bool has_come = known.coming.valid() &&
                        known.coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  if (has_come) Take(known);
  return known.answer.text;
}

void GitHead::Look() {
  for (auto& [path, known] : files_) {
    if (known.coming.valid() || known.answer.log.empty()) continue;
    std::error_code error;
    const auto time = fs::last_write_time(known.answer.log, error);
    if (!error && time != known.log_time) Start(path, known);
  }
}

void GitHead::Wait() {
  for (auto& [path, known] : files_) {
    if (known.coming.valid()) Take(known);
  }
}

}  // namespace coppice::editor
