// The bytes of BehaviorTree.CPP's FileLogger2 (.btlog), version 1:
//
//   18 bytes "BTCPP4-FileLogger2", 1 byte version, int32 size of the XML, the XML (full_xml.h),
//   int64 time of the first transition [us since 1970], then 9 bytes per transition: 48 bits time
//   since the first [us], 16 bits uid, 8 bits status; all little endian.
#ifndef COPPICE_BT_CORE_ANALYSIS_FORMATS_BTLOG_H_
#define COPPICE_BT_CORE_ANALYSIS_FORMATS_BTLOG_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/status.h"

namespace coppice {

struct BtlogTransition {
  std::int64_t time;  ///< [us since 1970]
  std::uint16_t uid;
  Status status;
};

struct Btlog {
  std::string xml;
  std::vector<BtlogTransition> transitions;
};

std::string WriteBtlog(const Btlog& log);

/// Nothing is returned if these are not the bytes of such a log. One that is cut off is read up to
/// its last whole transition, with a warning.
std::optional<Btlog> ReadBtlog(std::string_view bytes, const std::string& file,
                               Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_FORMATS_BTLOG_H_
