// Wakes a loop that waits for a descriptor, from any thread.
#pragma once

namespace computing {

class Bell {
public:
    Bell();
    ~Bell();
    Bell(const Bell&) = delete;
    Bell& operator=(const Bell&) = delete;

    void ring() const; // any thread
    void hear() const; // not readable until the next ring
    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

} // namespace computing
