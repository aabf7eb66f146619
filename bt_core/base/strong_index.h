// Numbers that count different things as types of their own: the number of a node is no number of a
// slot, though both are 32 bits and index arrays.
//
//   using RowIndex = StrongIndex<struct RowTag>;
//   inline constexpr RowIndex kNoRow{UINT32_MAX};
//
//   for (RowIndex row{0}; row < rows.size(); ++row) Show(rows[row], row + 1);
//   const ColumnIndex column = row;   // does not compile; nor does row == column, nor row = 7
//
// An index is made from a number explicitly, and is a number wherever one is wanted. An index and a
// distance make an index; the difference of two is a number. A constructed index is zero.
#ifndef COPPICE_BT_CORE_BASE_STRONG_INDEX_H_
#define COPPICE_BT_CORE_BASE_STRONG_INDEX_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>

namespace coppice {

template <class Tag>
class StrongIndex {
  template <class N>
  using IfNumber = std::enable_if_t<std::is_integral_v<N>, StrongIndex>;

 public:
  constexpr StrongIndex() = default;
  constexpr explicit StrongIndex(std::uint32_t number) : number_(number) {}
  template <class Other>
  StrongIndex(StrongIndex<Other>) = delete;

  constexpr operator std::uint32_t() const { return number_; }  // NOLINT: to index with

  constexpr StrongIndex& operator++() {
    ++number_;
    return *this;
  }
  constexpr StrongIndex operator++(int) { return StrongIndex(number_++); }
  constexpr StrongIndex& operator--() {
    --number_;
    return *this;
  }
  constexpr StrongIndex operator--(int) { return StrongIndex(number_--); }

  template <class N>
  friend constexpr IfNumber<N> operator+(StrongIndex index, N distance) {
    return StrongIndex(index.number_ + static_cast<std::uint32_t>(distance));
  }
  template <class N>
  friend constexpr IfNumber<N> operator-(StrongIndex index, N distance) {
    return StrongIndex(index.number_ - static_cast<std::uint32_t>(distance));
  }

 private:
  std::uint32_t number_ = 0;
};

namespace internal {
template <class A, class B>
using IfDifferent = std::enable_if_t<!std::is_same_v<A, B>, bool>;
}  // namespace internal

template <class A, class B>
internal::IfDifferent<A, B> operator==(StrongIndex<A>, StrongIndex<B>) = delete;
template <class A, class B>
internal::IfDifferent<A, B> operator!=(StrongIndex<A>, StrongIndex<B>) = delete;
template <class A, class B>
internal::IfDifferent<A, B> operator<(StrongIndex<A>, StrongIndex<B>) = delete;
template <class A, class B>
internal::IfDifferent<A, B> operator<=(StrongIndex<A>, StrongIndex<B>) = delete;
template <class A, class B>
internal::IfDifferent<A, B> operator>(StrongIndex<A>, StrongIndex<B>) = delete;
template <class A, class B>
internal::IfDifferent<A, B> operator>=(StrongIndex<A>, StrongIndex<B>) = delete;
template <class A, class B>
internal::IfDifferent<A, B> operator-(StrongIndex<A>, StrongIndex<B>) = delete;

}  // namespace coppice

template <class Tag>
struct std::hash<coppice::StrongIndex<Tag>> {
  std::size_t operator()(coppice::StrongIndex<Tag> index) const noexcept { return index; }
};

#endif  // COPPICE_BT_CORE_BASE_STRONG_INDEX_H_
