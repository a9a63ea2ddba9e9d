#include "pipeline/base/documents/sha256.h"

#include <glib.h>

namespace mien::pipeline {

Sha256::Sha256() : sum_(g_checksum_new(G_CHECKSUM_SHA256), g_checksum_free) {}

void Sha256::add(std::string_view bytes) {
  g_checksum_update(sum_.get(), reinterpret_cast<const guchar*>(bytes.data()),
                    static_cast<gssize>(bytes.size()));
}

std::string Sha256::finish() { return g_checksum_get_string(sum_.get()); }

std::string sha256_of(std::string_view bytes) {
  Sha256 sha;
  sha.add(bytes);
  return sha.finish();
}

}  // namespace mien::pipeline
