// Reports which sanitizer a test program was built with.
#pragma once

namespace trembler::test {

#if defined(__SANITIZE_THREAD__)
inline constexpr bool underThreadSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool underThreadSanitizer = __has_feature(thread_sanitizer);
#else
inline constexpr bool underThreadSanitizer = false;
#endif

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool underAddressSanitizer = true;
#elif defined(__has_feature)
inline constexpr bool underAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool underAddressSanitizer = false;
#endif

/// For tests that repeat themselves: memory errors occur in every repetition, races in every frame. The whole
/// number of repetitions is run without a sanitizer.
inline constexpr bool underSanitizer = underThreadSanitizer || underAddressSanitizer;

} // namespace trembler::test
