// Which rows of the equations were contacts of which bodies, from when on?
#pragma once

#include "physics/contact_press.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace simulation {

class ContactLog {
public:
    struct Contact {
        std::pair<std::size_t, std::size_t> bodies; // the lesser first
        std::vector<std::size_t> normals, friction; // unknowns of the equations
        std::size_t body = 0, support = 0;          // the same two, as surfaces have them
        std::shared_ptr<const physics::ContactSurfaces> surfaces = {};
    };
    // From that time on these are the contacts of these bodies, and no others.
    struct Entry {
        double time = 0;
        std::set<std::size_t> moving;
        std::vector<Contact> contacts;
    };

    // Times do not decrease.
    void add(Entry entry) { entries_.push_back(std::make_shared<const Entry>(std::move(entry))); }
    // In order of time; motions share them.
    using EntryPointer = std::shared_ptr<const Entry>;
    [[nodiscard]] const std::vector<EntryPointer>& entries() const { return entries_; }
    // A contact of these bodies, the lesser first, began at that time or later.
    [[nodiscard]] bool hasHad(const std::pair<std::size_t, std::size_t>& bodies,
                              double since) const {
        return std::ranges::any_of(entries_, [&](const EntryPointer& entry) {
            return entry->time >= since &&
                   std::ranges::find(entry->contacts, bodies, &Contact::bodies) !=
                       entry->contacts.end();
        });
    }
    [[nodiscard]] ContactLog upTo(double until) const {
        ContactLog log;
        for (const EntryPointer& entry : entries_)
            if (entry->time <= until)
                log.entries_.push_back(entry);
        return log;
    }

private:
    std::vector<EntryPointer> entries_;
};

} // namespace simulation
