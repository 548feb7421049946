#pragma once
#include "lambert/image/image.h"

#include <ImfHeader.h>

#include <map>
#include <string>

namespace lambert {

/// What a header says beside the pixels: strings into `metadata`, other values into `attributes`. How the file is laid
/// out (channels, windows, compression, tiles, part names) and the preview are left out.
void read_attributes(const Imf::Header& header, std::map<std::string, std::string>& metadata,
                     std::map<std::string, Attribute>& attributes);

/// Throws Error naming the attribute when its value is none of its type or its name is one of the layout's.
void write_attributes(Imf::Header& header, const std::map<std::string, std::string>& metadata,
                      const std::map<std::string, Attribute>& attributes);

}  // namespace lambert
