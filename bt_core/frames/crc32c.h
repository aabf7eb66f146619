// CRC-32C (Castagnoli), the checksum of iSCSI: RFC 3720, section 12.1.
#ifndef COPPICE_BT_CORE_FRAMES_CRC32C_H_
#define COPPICE_BT_CORE_FRAMES_CRC32C_H_

#include <cstddef>
#include <cstdint>

namespace coppice {

/// The checksum of some bytes. To go on behind other bytes, hand in their checksum.
std::uint32_t Crc32c(const void* bytes, std::size_t size, std::uint32_t before = 0);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_CRC32C_H_
