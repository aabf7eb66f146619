// Records of runs, and what can be asked of them.
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/recorded_tree.h"
#include "bt_core/analysis/statistics.h"
#include "bt_core/analysis/told_tick.h"
#include "bt_core/analysis/why/why_text.h"
#include "bt_core/data/value_bytes.h"
#include "bt_core/python/bind.h"
#include "bt_core/python/values.h"

namespace coppice::python {
namespace {

py::object FromBytes(const std::string& bytes) {
  const PlainValue value = ReadPlainValue(bytes);
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (FormOfValue(bytes) != ValueForm::kJson) return TextOf(*text);
    return py::module_::import("json").attr("loads")(TextOf(*text));
  }
  if (const auto* truth = std::get_if<bool>(&value)) return py::bool_(*truth);
  if (const auto* number = std::get_if<std::int64_t>(&value)) return py::int_(*number);
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return py::int_(*number);
  if (const auto* number = std::get_if<double>(&value)) return py::float_(*number);
  return py::none();
}

// How scenarios write a key: that of the main tree by its name, others with their tree before.
std::string KeyPath(const TreeDescription& tree, const ToldTick::Write& write) {
  return write.scope == tree.main_tree ? write.key : write.scope + "/" + write.key;
}

py::tuple ToPython(const TreeDescription& tree, const ToldTick& tick, Time start) {
  py::list changes;
  for (const auto& change : tick.changes) {
    changes.append(py::make_tuple(TextOf(change.node), change.from, change.to));
  }
  py::list writes;
  for (const auto& write : tick.writes) {
    writes.append(
        py::make_tuple(TextOf(KeyPath(tree, write)), FromBytes(write.value), TextOf(write.writer)));
  }
  py::list messages;
  for (const auto& message : tick.messages) {
    messages.append(py::make_tuple(TextOf(message.node), TextOf(message.text)));
  }
  return py::make_tuple(tick.number, ToSeconds(tick.time - start), ToSeconds(tick.duration),
                        tick.result, changes, writes, messages);
}

class Record {
 public:
  explicit Record(Recording run) : run_(std::move(run)) {}
  const Recording& run() const { return run_; }

  std::string Why(const std::string& node, std::optional<std::uint64_t> tick) const {
    const std::size_t entry = EntryOf(tick);
    Diagnostics diagnostics;
    const RecordedTree tree = CompileRecorded(run_.trees()[run_.TreeOf(entry)],
                                              std::make_shared<Registry>(), diagnostics);
    Diagnostics advice;
    const NodeIndex found = tree.Find(node, advice);
    if (found == kNoNode) throw py::key_error(advice.ToString());
    const TickView now = run_.Before(entry);
    std::optional<TickView> before;
    if (const auto earlier = run_.TickBefore(entry)) before = run_.Before(*earlier);
    return PrintWhy(tree, WhyOf(tree, now, before ? &*before : nullptr, found), run_.start());
  }

 private:
  std::size_t EntryOf(std::optional<std::uint64_t> tick) const {
    const auto& ticks = run_.ticks();
    if (ticks.empty()) throw py::index_error("there is no tick in this record");
    std::size_t entry = ticks.size() - 1;
    while (!tick && entry > 0 && ticks[entry].result == Status::kIdle) --entry;
    if (tick) entry = run_.Find(*tick);
    if (entry < ticks.size()) return entry;
    throw py::index_error("the record ends with tick " + std::to_string(ticks.back().number));
  }

  const Recording run_;
};

std::pair<std::shared_ptr<Record>, std::vector<Diagnostic>> Open(const std::string& path) {
  const py::gil_scoped_release release;
  Diagnostics diagnostics;
  std::optional<Recording> run = LoadRecording(path, diagnostics);
  return {run ? std::make_shared<Record>(*std::move(run)) : nullptr, diagnostics.all()};
}

// Goes through the ticks in order.
class RecordTicks {
 public:
  explicit RecordTicks(std::shared_ptr<const Record> record) : record_(std::move(record)) {}

  py::tuple Next() {
    const Recording& run = record_->run();
    if (tick_ == run.ticks().size()) throw py::stop_iteration();
    const TreeDescription& tree = run.trees()[run.TreeOf(tick_)];
    while (section_ < run.sections().size() && run.sections()[section_].first_tick <= tick_) {
      follower_.emplace(ShapeOf(tree), run.sections()[section_++].state);
    }
    const ToldTick told = TellTick(tree, *follower_, run.EventsOf(tick_++));
    return ToPython(tree, told, run.start());
  }

 private:
  const std::shared_ptr<const Record> record_;
  std::size_t tick_ = 0;
  std::size_t section_ = 0;  // the next one
  std::optional<HistoryFollower> follower_;
};

py::dict MetadataOf(const Record& record) {
  py::dict metadata;
  for (const auto& [key, value] : record.run().trees().front().info.metadata) {
    metadata[TextOf(key)] = TextOf(value);
  }
  return metadata;
}

py::list NodesOf(const Record& record) {
  py::list nodes;
  for (const DescribedNode& node : record.run().trees().front().nodes) {
    nodes.append(py::make_tuple(TextOf(node.path), TextOf(node.id)));
  }
  return nodes;
}

double WallStart(const Record& record) {
  const RunInfo& info = record.run().trees().front().info;
  return ToSeconds(Duration(info.wall_start.time_since_epoch()));
}

}  // namespace

void BindRecords(py::module_& module) {
  py::class_<RecordTicks>(module, "RecordTicks")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &RecordTicks::Next);
  py::class_<Record, std::shared_ptr<Record>>(module, "Record")
      .def("ticks",
           [](const std::shared_ptr<Record>& record) {
             return std::make_unique<RecordTicks>(record);
           })
      .def("__len__", [](const Record& record) { return record.run().ticks().size(); })
      .def("main_tree",
           [](const Record& record) { return TextOf(record.run().trees().front().main_tree); })
      .def("metadata", &MetadataOf)
      .def("nodes", &NodesOf)
      .def("wall_start", &WallStart)
      .def("is_closed", [](const Record& record) { return record.run().is_closed(); })
      .def(
          "why",
          [](const Record& record, const std::string& node, std::optional<std::uint64_t> tick) {
            return TextOf(record.Why(node, tick));
          },
          py::arg("node"), py::arg("tick"))
      .def("statistics", [](const Record& record) {
        return TextOf(StatisticsToJson(StatisticsOf(record.run()), StatisticsOrder::kTree));
      });
  module.def("open_record", &Open, py::arg("path"));
}

}  // namespace coppice::python
