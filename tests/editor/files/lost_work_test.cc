// Nothing that stood on the screen five seconds ago is lost, whatever is killed and when: sessions
// of random work in which the editor is killed, also in the middle of what it writes, the disk
// fails for a while, and the file is removed, comes back or is changed by others.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/editor/driver.h"
#include "tests/editor/files/dying_calls.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr int kSessions = 1000;
constexpr double kPromise = 5;  // s
constexpr float kSlice = 0.25;  // s; the window looks at the clock at least so often
constexpr int kDiskCalls = 60;  // of a session, about; see DieAtDiskCall

std::string Disk(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A text of a tree that is like no other.
std::string Tree(int number) {
  return "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"Main\">\n<Sleep msec=\"" +
         std::to_string(number) + "\"/>\n</BehaviorTree>\n</root>\n";
}

// In a process of its own, which is killed in the middle. What stands on the screen goes to a log
// whenever it changes: time, name of the file, number of the text; and when the disk fails.
class Session {
 public:
  Session(const std::string& folder, unsigned seed)
      : folder_(folder), random_(seed), log_(std::fopen((folder + "/log").c_str(), "w")) {}

  [[noreturn]] void Run() {
    EditorOptions options;
    options.backup_folder = folder_ + "/state";
    editor_ = std::make_unique<Editor>(WithSharedFonts(options));
    editor_->Open(folder_ + "/a.xml");
    editor_->Open(folder_ + "/b.xml");
    DieAtDiskCall(Pick(1, 2 * kDiskCalls));
    for (int steps = Pick(5, 40); steps > 0; --steps) Step();
    DieAtDiskCall(0);
    Mend();
    Log("end", 0);
    _exit(0);  // as by SIGKILL: nothing is tidied up
  }

 private:
  int Pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  OpenProject& project() { return editor_->state().workspace.project(); }

  void Step() {
    switch (Pick(0, 9)) {
      case 0:
        editor_->state().commands.Run("file.save");
        break;
      case 1:
        LogDestroyed(folder_ + "/a.xml");
        fs::remove(folder_ + "/a.xml");
        break;
      case 2:
        WriteByOthers(folder_ + "/b.xml");
        break;
      case 3:
        Break();
        break;
      case 4:
        Mend();
        break;
      case 5:
        if (project().files().size() < 4) editor_->state().workspace.New(editor_->now());
        break;
      default:
        Edit();
    }
    for (int slices = Pick(0, 8); slices > 0; --slices) {
      editor_->Rest(kSlice);
      Log("alive", 0);
    }
  }

  void Log(const std::string& what, int text) {
    std::fprintf(log_, "%.3f %s %d\n", editor_->now(), what.c_str(), text);
    std::fflush(log_);
  }

  // What the user had saved was safe; it is not the editor that loses it.
  void LogDestroyed(const std::string& path) {
    const std::string text = Disk(path);
    const std::size_t number = text.find("msec=\"");
    if (number != std::string::npos) Log("destroyed:" + path, std::stoi(text.substr(number + 6)));
  }

  // What the user has not changed becomes theirs.
  void WriteByOthers(const std::string& path) {
    LogDestroyed(path);
    WriteFile(path, Tree(++last_));
    if (!project().Find(path)->is_dirty()) Log(path, last_);
  }

  void Edit() {
    const auto& files = project().files();
    auto at = files.begin();
    std::advance(at, Pick(0, static_cast<int>(files.size()) - 1));
    const std::string path = at->first;
    project().SetText(path, "Type", Tree(++last_));
    editor_->state().workspace.Refresh(editor_->now());
    Log(path, last_);
  }

  // Nothing can be written where the copies are.
  void Break() {
    if (is_broken_) return;
    is_broken_ = true;
    Log("broken", 0);
    std::error_code none_yet;
    fs::rename(folder_ + "/state", folder_ + "/away", none_yet);
    WriteFile(folder_ + "/state", "");
  }
  void Mend() {
    if (!is_broken_) return;
    is_broken_ = false;
    fs::remove(folder_ + "/state");
    std::error_code none_yet;
    fs::rename(folder_ + "/away", folder_ + "/state", none_yet);
    Log("mended", 0);
  }

  const std::string folder_;
  std::mt19937 random_;
  std::FILE* const log_;
  std::unique_ptr<Editor> editor_;
  bool is_broken_ = false;
  int last_ = 0;
};

struct Shown {
  double time;
  int text;
};

struct Story {
  double end = 0;
  double kept =
      -1;  // what stood there then can have been kept: the disk had worked for long enough
  std::map<std::string, std::vector<Shown>> shown;  // by path
  std::map<std::string, std::set<int>> destroyed;   // likewise: what others have destroyed
};

// What Break() has left when the editor was killed before Mend().
void MendAfterwards(const std::string& folder) {
  if (fs::is_regular_file(folder + "/state")) fs::remove(folder + "/state");
  if (fs::exists(folder + "/away")) fs::rename(folder + "/away", folder + "/state");
}

Story ReadLog(const std::string& path) {
  Story story;
  std::ifstream stream(path);
  double time = 0, good_since = 0;
  bool is_good = true;
  std::string what;
  for (int text = 0; stream >> time >> what >> text;) {
    story.end = time;
    if (is_good && time - good_since >= kPromise) story.kept = time - kPromise;
    if (what == "broken") {
      is_good = false;
    } else if (what == "mended") {
      is_good = true;
      good_since = time;
    } else if (what.rfind("destroyed:", 0) == 0) {
      story.destroyed[what.substr(10)].insert(text);
    } else if (what != "alive" && what != "end") {
      story.shown[what].push_back({time, text});
    }
  }
  return story;
}

// What stood there `since`, and all that came after.
std::vector<int> TextsSince(const std::vector<Shown>& shown, double since) {
  std::vector<int> texts;
  for (const Shown& one : shown) {
    if (one.time <= since) texts.clear();
    texts.push_back(one.text);
  }
  return shown.front().time <= since ? texts : std::vector<int>();
}

TEST(LostWork, NothingThatStoodOnTheScreenFiveSecondsAgoIsLost) {
  WithSharedFonts({});  // read once, for all processes
  // In memory: a thousand sessions wait for the disk for minutes otherwise.
  if (fs::exists("/dev/shm")) setenv("TMPDIR", "/dev/shm", 1);
  int checked = 0;
  int killed = 0;
  for (unsigned seed = 1; seed <= kSessions; ++seed) {
    const TemporaryFolder folder;
    for (const char* name : {"/a.xml", "/b.xml"}) WriteFile(folder.path() + name, Tree(0));
    const pid_t process = fork();
    if (process == 0) Session(folder.path(), seed).Run();
    int status = 0;
    ASSERT_EQ(waitpid(process, &status, 0), process);
    const bool was_killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
    ASSERT_TRUE(was_killed || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) << "seed " << seed;
    if (was_killed) ++killed;
    MendAfterwards(folder.path());
    Story story = ReadLog(folder.path() + "/log");
    UnsavedWork work(folder.path() + "/state");
    work.Look(OpenProject());
    for (const auto& [path, shown] : story.shown) {
      const std::vector<int> texts = TextsSince(shown, story.kept);
      if (texts.empty()) continue;
      std::set<std::string> found = {Disk(path)};
      for (const UnsavedCopy& copy : work.left()) {
        if (copy.path == UnsavedWork::AbsolutePath(path)) found.insert(*UnsavedWork::TextOf(copy));
      }
      ++checked;
      for (const int text : story.destroyed[path]) found.insert(Tree(text));
      EXPECT_TRUE(std::any_of(texts.begin(), texts.end(),
                              [&](int text) { return found.count(Tree(text)) > 0; }))
          << "seed " << seed << ", " << path << ", text " << texts.front() << "\n"
          << Disk(folder.path() + "/log") << "on the disk: " << Disk(path);
    }
  }
  EXPECT_GT(checked, kSessions / 2) << "hardly anything was asked";
  RecordProperty("killed_in_the_middle", killed);
  EXPECT_GT(killed, kSessions / 3) << "hardly any was killed in the middle";
}

}  // namespace
}  // namespace coppice::editor
