#include "service/pictures.h"

#include "ipc/base64.h"

#include <algorithm>
#include <utility>

namespace service {

Pictures::Pictures(std::unique_ptr<render::DrawingThread> thread, Draw draw,
                   std::function<void()> wake)
    : draw_(std::move(draw)), wake_(std::move(wake)), thread_(std::move(thread)) {}

std::vector<std::byte> pixelsFor(render::Image& image) {
    std::vector<std::byte> pixels(image.stride * static_cast<std::size_t>(image.size.height));
    image.pixels = pixels;
    return pixels;
}

std::vector<Pictures::Asked>::iterator Pictures::of(Customer customer) {
    const auto last = std::find_if(asked_.rbegin(), asked_.rend(),
                                   [&](const Asked& one) { return one.customer == customer; });
    return last == asked_.rend() ? asked_.end() : std::prev(last.base());
}

bool Pictures::draws(Customer customer) const {
    return std::ranges::find(asked_, customer, &Asked::customer) != asked_.end();
}

void Pictures::draw(Customer customer, Wish wish, Done done) {
    asked_.push_back({++number_, customer, std::move(done), {}});
    thread_->draw(customer, [this, number = number_, wish = std::move(wish)] {
        const Instant began = Clock::now();
        Drawn drawn;
        render::Image into = wish.into;
        std::vector<std::byte> own; // made now: many that wait are replaced
        if (!wish.slot)
            own = pixelsFor(into);
        drawn.isFine = draw_(wish.drawing, into, wish.around);
        if (drawn.isFine && wish.over)
            wish.over(into);
        if (drawn.isFine && !wish.slot)
            drawn.packed = ipc::toBase64(own);
        drawn.lasted = Clock::now() - began;
        {
            const std::lock_guard lock(mutex_);
            drawn_.emplace_back(number, std::move(drawn));
        }
        wake_();
    });
}

bool Pictures::takeBack(Customer customer) {
    if (!thread_->takeBack(customer))
        return false;
    asked_.erase(of(customer));
    return true;
}

void Pictures::whenFree(Customer customer, std::function<void()> done) {
    if (const auto asked = of(customer); asked != asked_.end())
        asked->whenFree.push_back(std::move(done));
    else
        done();
}

void Pictures::collect() {
    std::vector<std::pair<unsigned, Drawn>> all;
    {
        const std::lock_guard lock(mutex_);
        all = std::exchange(drawn_, {});
    }
    for (auto& [number, drawn] : all) {
        const auto found = std::ranges::find(asked_, number, &Asked::number);
        const Asked asked = std::move(*found);
        asked_.erase(found);
        asked.done(std::move(drawn));
        for (const auto& free : asked.whenFree)
            free();
    }
}

} // namespace service
