// The two faces of `coppice replay`: lines for people, and JSON objects for scripts.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_PRINTER_H_
#define COPPICE_BT_CORE_CLI_REPLAY_PRINTER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/record/record_reader.h"

namespace coppice {

/// Counted while the entries go by.
struct ReplaySummary {
  explicit ReplaySummary(const RecordHeader& header);
  void Add(const RecordEntry& entry);

  struct Node {
    std::uint64_t successes = 0;
    std::uint64_t failures = 0;
  };
  std::vector<Node> nodes;
  std::uint64_t ticks = 0;  ///< in which something happened
  std::uint64_t changes = 0;
  std::uint64_t writes = 0;
  std::uint64_t notes = 0;
  std::uint64_t gaps = 0;
  std::uint64_t lost_ticks = 0;
  std::uint64_t lost_notes = 0;
  Time first;  ///< start of the record
  Time last;   ///< of the last entry
  bool closed = false;
  std::size_t damages = 0;

  /// Nothing is missing in the record.
  bool complete() const { return closed && damages == 0 && gaps == 0; }
};

class ReplayPrinter {
 public:
  virtual ~ReplayPrinter() = default;
  virtual void Header(const RecordHeader& header) = 0;
  virtual void Entry(const RecordedTick& tick) = 0;
  virtual void Entry(const RecordedNote& note) = 0;
  virtual void Entry(const RecordedGap& gap) = 0;
  virtual void Entry(const RecordedEnd& end) = 0;
  virtual void Damage(const RecordDamage& damage) = 0;
  virtual void Summary(const ReplaySummary& summary) = 0;
};

/// The header must outlive the printer. Times are shown in seconds since its start.
std::unique_ptr<ReplayPrinter> MakeTextPrinter(std::ostream& out, const RecordHeader& header);
std::unique_ptr<ReplayPrinter> MakeJsonPrinter(std::ostream& out, const RecordHeader& header);

/// The text in quotes, as JSON wants it. Bytes that are not UTF-8 become U+FFFD.
std::string JsonText(std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_PRINTER_H_
