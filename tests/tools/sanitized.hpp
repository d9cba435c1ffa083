// BLOCKS_SANITIZED is defined in builds with the address or the thread sanitizer. These
// replace malloc and reserve terabytes of addresses.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BLOCKS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define BLOCKS_SANITIZED
#endif
#endif
