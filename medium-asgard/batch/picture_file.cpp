#include "batch/picture_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include <png.h>

namespace batch {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Bytes R, G, B without gaps.
std::vector<std::byte> rgb(const render::Image& image) {
    std::vector<std::byte> pixels;
    const auto width = static_cast<std::size_t>(image.size.width);
    const auto height = static_cast<std::size_t>(image.size.height);
    pixels.reserve(3 * width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::byte* bgrx = &image.pixels[y * image.stride + 4 * x];
            pixels.insert(pixels.end(), {bgrx[2], bgrx[1], bgrx[0]});
        }
    return pixels;
}

bool writePng(std::FILE* file, const render::Image& image, const std::vector<std::byte>& pixels,
              std::string& why) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.size.width);
    header.height = static_cast<png_uint_32>(image.size.height);
    header.format = PNG_FORMAT_RGB;
    if (png_image_write_to_stdio(&header, file, 0, pixels.data(), 0, nullptr) != 0)
        return true;
    why = header.message;
    return false;
}

} // namespace

bool writePicture(const std::string& file, PictureFormat format, const render::Image& image,
                  std::string& why) {
    const File stream(std::fopen(file.c_str(), "wb"), std::fclose);
    if (!stream) {
        why = std::strerror(errno);
        return false;
    }
    const std::vector<std::byte> pixels = rgb(image);
    if (format == PictureFormat::png) {
        if (!writePng(stream.get(), image, pixels, why))
            return false;
    } else {
        const std::string header = "P6\n" + std::to_string(image.size.width) + " " +
                                   std::to_string(image.size.height) + "\n255\n";
        std::fwrite(header.data(), 1, header.size(), stream.get());
        std::fwrite(pixels.data(), 1, pixels.size(), stream.get());
    }
    if (std::fflush(stream.get()) == 0 && !std::ferror(stream.get()))
        return true;
    why = std::strerror(errno);
    return false;
}

} // namespace batch
