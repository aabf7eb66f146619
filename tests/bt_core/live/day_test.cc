// A day of a robot, with record and live view: nothing grows.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bt_core/live/server/live_publisher.h"
#include "bt_core/record/record_reader.h"
#include "bt_core/record/recorder.h"
#include "tests/bt_core/live/watched_tree.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

constexpr int kTicksPerHour = 36000;  // ten a second
constexpr std::uint64_t kFileBytes = 32 << 10;
constexpr std::uint32_t kKeepFiles = 3;

// The thread sanitizer's shadow of the memory takes several times as much, and comes later; the
// address sanitizer keeps what is freed for a while (sanitizer_options.cc).
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kSlackBytes = 40 << 20;
#else
constexpr std::size_t kSlackBytes = 4 << 20;
#endif

std::size_t ResidentBytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t size = 0;
  std::size_t resident = 0;
  statm >> size >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

constexpr char kArbiter[] = R"(
<root BTCPP_format="4"><BehaviorTree ID="Main"><ReactiveFallback>
  <ReactiveSequence>
    <ScriptCondition code="battery &lt; 20"/>
    <Delay delay_msec="600000"><Script code="charged := 1"/></Delay>
  </ReactiveSequence>
  <Sequence>
    <Fill flag="{flag}" number="{number}" large="{large}" ratio="{ratio}" third="{third}"
          text="{text}" spot="{spot}"/>
    <Sleep msec="1700"/>
    <Alternate/>
  </Sequence>
</ReactiveFallback></BehaviorTree></root>)";

class ADay : public testing::Test {
 protected:
  static std::shared_ptr<const Program> Load() {
    auto registry = std::make_shared<Registry>();
    registry->Register<Fill>("Fill");
    registry->Register<Alternate>("Alternate");
    Diagnostics diagnostics;
    auto project = Project::FromText(kArbiter, "day.xml", diagnostics);
    auto program = Compile(std::make_shared<const Project>(*std::move(project)),
                           std::move(registry), diagnostics);
    if (!program) throw std::logic_error(diagnostics.ToString());
    return program;
  }
  static LiveOptions AnyPort() {
    LiveOptions options;
    options.port = 0;
    options.history_bytes = 1 << 20;
    return options;
  }
  static RecorderOptions Rotating() {
    RecorderOptions options;
    options.max_file_bytes = kFileBytes;
    options.keep_files = kKeepFiles;
    return options;
  }

  // The battery falls from full to empty in an hour.
  void RunAnHour() {
    for (int i = 0; i < kTicksPerHour; ++i) {
      if (i % 100 == 0) battery_.Send(100.0 - 100.0 * i / kTicksPerHour);
      executor_.Tick();
      clock_.Advance(std::chrono::milliseconds(100));
      if (i % 1000 == 0) stream_.Flush();  // simulated time is faster than any disk
    }
  }

  SimulatedClock clock_{std::chrono::seconds(1)};
  Executor executor_{Load(), clock_};
  Sender<double> battery_ = executor_.Writer<double>("battery");
  EventStream stream_{executor_};
  TemporaryFolder folder_;
};

TEST_F(ADay, OfTenTicksASecondKeepsMemoryAndDiskFlat) {
  const std::string path = folder_.Path("day.coppice");
  Recorder recorder(stream_, path, Rotating());
  const LivePublisher live(stream_, AnyPort());
  RunAnHour();
  RunAnHour();
  const std::size_t after_two_hours = ResidentBytes();
  for (int hour = 2; hour < 24; ++hour) RunAnHour();
  EXPECT_LT(ResidentBytes(), after_two_hours + kSlackBytes);
  EXPECT_EQ(recorder.Close().problem(), "");
  EXPECT_EQ(recorder.lost_ticks(), 0U);
  std::uint64_t bytes = 0;
  std::uint32_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder_.Path(""))) {
    bytes += file.file_size();
    ++files;
  }
  EXPECT_EQ(files, kKeepFiles) << bytes << " bytes";
  EXPECT_LE(bytes, (kKeepFiles + 1) * kFileBytes);
  EXPECT_EQ(executor_.ticks(), 24U * kTicksPerHour);
}

}  // namespace
}  // namespace coppice
