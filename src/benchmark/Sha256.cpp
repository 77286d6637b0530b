// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/Sha256.h"

#include <array>
#include <stdexcept>

#include <openssl/evp.h>

namespace narrows
{
std::string sha256(const std::string &bytes)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
        throw std::runtime_error("OpenSSL offers no SHA-256");
    std::string text;
    for (unsigned int i = 0; i < size; ++i)
        for (const int nibble : {digest[i] >> 4, digest[i] & 15})
            text += "0123456789abcdef"[nibble];
    return text;
}
}  // namespace narrows
