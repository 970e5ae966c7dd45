#include "events/body_readers.h"

#include "equations/partition.h"

#include <algorithm>

namespace simulation {

BodyReaders::BodyReaders(const physics::EquationsOfMotion& equations,
                         const std::vector<BodyRecord>& records, double start)
    : readers_(records.size()), bodyOf_(equations.owners) {
    const auto reads = solution::readsOf(equations.set, start);
    std::vector<std::set<std::size_t>> direct(records.size());
    for (std::size_t i = 0; i < reads.size(); ++i)
        for (const std::size_t read : reads[i])
            direct[bodyOf_[read]].insert(bodyOf_[i]);
    for (std::size_t b = 0; b < records.size(); ++b) {
        std::vector<std::size_t> open{b};
        while (!open.empty()) {
            const std::size_t next = open.back();
            open.pop_back();
            for (const std::size_t reader : direct[next])
                if (reader != b && readers_[b].insert(reader).second)
                    open.push_back(reader);
        }
    }
}

std::vector<std::size_t> BodyReaders::cutBy(const solution::Event& event) const {
    std::vector<std::size_t> cut;
    for (const std::size_t unknown : event.touched) {
        const std::size_t body = bodyOf_[unknown];
        if (!cut.empty() && cut.back() == body)
            continue;
        cut.push_back(body);
        cut.insert(cut.end(), readers_[body].begin(), readers_[body].end());
    }
    std::ranges::sort(cut);
    cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
    return cut;
}

} // namespace simulation
