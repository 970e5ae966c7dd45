#include "point_edits/shape_edit.h"

#include "editing/number_text.h"
#include "editing/origin.h"
#include "point_edits/shape_points.h"

#include "script/numbers.h"

#include <algorithm>
#include <utility>

namespace editing {

using geometry::Vector;

namespace {

std::string listText(const Vector& v) {
    return "{" + numberText(v.x(), 0) + " " + numberText(v.y(), 0) + " " + numberText(v.z(), 0) +
           "}";
}

std::string pointsText(const std::vector<Vector>& points) {
    std::string text;
    for (const Vector& p : points)
        text += (text.empty() ? "" : " ") + listText(p);
    return "{" + text + "}";
}

constexpr std::string_view shapeOptions[] = { // in the order of the variant
    "-sphere",  "-box",       "-points", "-cylinder", "-cone",
    "-capsule", "-ellipsoid", "-plane",  "-tube",     "-bowl"};

std::string_view optionOf(const scene::Part& part) { return shapeOptions[part.shape.index()]; }

// "2", "{1 2 3}", "{{0 0 0} ...}"; nothing behind -plane.
std::string valueText(const scene::Part& part) {
    if (const auto* hull = std::get_if<scene::HullShape>(&part.shape))
        return pointsText(hull->points);
    const std::vector<double> sizes = sizesOf(part);
    if (sizes.size() == 1)
        return numberText(sizes.front(), 0);
    std::string text;
    for (const double size : sizes)
        text += (text.empty() ? "" : " ") + numberText(size, 0);
    return sizes.empty() ? text : "{" + text + "}";
}

std::string shapeText(const scene::Part& part) {
    const std::string value = valueText(part);
    return std::string(optionOf(part)) + (value.empty() ? "" : " " + value);
}

std::string colourText(const scene::Color& color) {
    return "{" + numberText(color.red, 0) + " " + numberText(color.green, 0) + " " +
           numberText(color.blue, 0) + "}";
}

// An element of the text's list with its place in the text.
struct Item {
    scene::Range range, content;
    bool literal = false;
    std::string value;
};

std::vector<Item> itemsOf(const std::string& text, scene::Range content) {
    std::vector<Item> items;
    const auto list =
        script::elementsOf(std::string_view(text).substr(content.from, content.to - content.from));
    for (const script::Element& one : list.elements)
        items.push_back({{content.from + one.range.from, content.from + one.range.to},
                         {content.from + one.content.from, content.from + one.content.to},
                         one.literal,
                         one.value});
    return items;
}

// Words of an option in a part's description, with its value.
std::size_t optionSize(const Item& option) { return option.value == "-plane" ? 1 : 2; }

// The description as it is written: for each part its option words and their values.
struct WrittenPart {
    std::vector<std::pair<Item, Item>> words; // one "-sub {...}", or all "-face {...}" of the hull
    [[nodiscard]] bool isFaces() const { return words.front().first.value == "-face"; }
};

class Description {
public:
    Description(const std::string& text, scene::Range content) : text_(text), content_(content) {
        std::optional<std::size_t> hull;
        items_ = itemsOf(text, content);
        for (std::size_t i = 0; i + 1 < items_.size(); i += 2) {
            const bool isFace = items_[i].value == "-face";
            if (!isFace || !hull)
                parts_.emplace_back();
            if (isFace && !hull)
                hull = parts_.size() - 1;
            (isFace ? parts_[*hull] : parts_.back()).words.emplace_back(items_[i], items_[i + 1]);
        }
    }

    [[nodiscard]] const std::vector<WrittenPart>& parts() const { return parts_; }

    void change(std::size_t index, const scene::Part& before, const scene::Part& after);
    void remove(std::size_t index);
    void append(const scene::Part& part);
    [[nodiscard]] text::Edits edits();

private:
    void put(scene::Range range, std::string text) {
        if (text_.compare(range.from, range.to - range.from, text) != 0)
            edits_.push_back({{range.from, range.to}, std::move(text)});
    }
    void putNumber(const Item& item, double value) {
        if (const auto old = script::decimalNumber(item.value); !old || *old != value)
            put(item.range, numberText(value, 0, item.value));
    }
    void putVector(const Item& item, const Vector& value) {
        putNumbers(item, {value.x(), value.y(), value.z()}, listText(value));
    }
    // `otherwise` where the list does not stand in the text.
    void putNumbers(const Item& item, const std::vector<double>& values, std::string otherwise) {
        const auto numbers = itemsOf(text_, item.content);
        if (numbers.size() != values.size())
            return put(item.range, std::move(otherwise));
        for (std::size_t k = 0; k < values.size(); ++k)
            putNumber(numbers[k], values[k]);
    }
    void putPoints(const Item& item, const std::vector<Vector>& before,
                   const std::vector<Vector>& after);
    void changeShape(const std::vector<Item>& items, const scene::Part& before,
                     const scene::Part& after);
    void changeSub(const Item& value, const scene::Part& before, const scene::Part& after);
    void changeFaces(const WrittenPart& faces, const scene::Part& before, const scene::Part& after);
    void removeWithin(const std::vector<Item>& items, const Item* value);
    void removeWhole(const std::pair<Item, Item>& words);

    const std::string& text_;
    scene::Range content_;
    std::vector<Item> items_;
    std::vector<WrittenPart> parts_;
    std::vector<std::size_t> removed_; // places in items_ of option words that go with their values
    std::string appended_;
    text::Edits edits_;
};

// Points that stay keep their bytes: what is common to both at the beginning and at the end, and
// those between that only moved, when there are as many as before.
void Description::putPoints(const Item& item, const std::vector<Vector>& before,
                            const std::vector<Vector>& after) {
    const auto items = itemsOf(text_, item.content);
    if (items.size() != before.size() || items.empty())
        return put(item.range, pointsText(after));
    if (before.size() == after.size()) {
        for (std::size_t i = 0; i < items.size(); ++i)
            if (before[i] != after[i])
                putVector(items[i], after[i]);
        return;
    }
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t head = 0, tail = 0;
    while (head < shorter && before[head] == after[head])
        ++head;
    while (tail < shorter - head &&
           before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    std::string added;
    for (std::size_t i = head; i + tail < after.size(); ++i)
        added += " " + listText(after[i]);
    const std::size_t from = head > 0 ? items[head - 1].range.to : item.content.from;
    const std::size_t to =
        head + tail < before.size() ? items[before.size() - tail - 1].range.to : from;
    if (head == 0 && !added.empty()) {
        added.erase(0, 1);
        if (tail > 0 && to == from)
            added += " ";
    }
    put({from, to}, added);
}

void Description::changeSub(const Item& value, const scene::Part& before,
                            const scene::Part& after) {
    const auto items = itemsOf(text_, value.content);
    const auto find = [&](std::string_view option) -> const Item* {
        for (std::size_t i = 0; i + 1 < items.size(); i += optionSize(items[i]))
            if (items[i].value == option)
                return &items[i + 1];
        return nullptr;
    };
    std::string inserted;
    const auto vector = [&](const char* option, const Vector& old, const Vector& now) {
        if (old == now)
            return;
        if (const Item* item = find(option))
            putVector(*item, now);
        else
            inserted += std::string(option) + " " + listText(now) + " ";
    };
    vector("-pos", before.position, after.position);
    vector("-rot", before.rotation, after.rotation);
    if (before.appearance.color != after.appearance.color) {
        const auto& color = after.appearance.color;
        const Item* item = find("-color");
        if (item && color)
            put(item->range, colourText(*color));
        else if (item)
            removeWithin(items, item);
        else if (color)
            inserted += "-color " + colourText(*color) + " ";
    }
    if (!inserted.empty() && !items.empty())
        put({items.front().range.from, items.front().range.from}, inserted);
    if (before.shape == after.shape)
        return;
    changeShape(items, before, after);
}

void Description::changeShape(const std::vector<Item>& items, const scene::Part& before,
                              const scene::Part& after) {
    for (std::size_t i = 0; i < items.size(); i += optionSize(items[i])) {
        const std::string& is = items[i].value;
        if (std::ranges::find(shapeOptions, is) == std::end(shapeOptions))
            continue;
        const Item& at = items[std::min(i + optionSize(items[i]) - 1, items.size() - 1)];
        if (is != optionOf(after)) {
            put({items[i].range.from, at.range.to}, shapeText(after));
        } else if (const auto* hull = std::get_if<scene::HullShape>(&after.shape)) {
            putPoints(at, std::get<scene::HullShape>(before.shape).points, hull->points);
        } else if (const auto sizes = sizesOf(after); sizes.size() == 1) {
            putNumber(at, sizes.front());
        } else if (!sizes.empty()) {
            putNumbers(at, sizes, valueText(after));
        }
    }
}

// A vertex stands in several faces, and in each is one point of the part.
void Description::changeFaces(const WrittenPart& faces, const scene::Part& before,
                              const scene::Part& after) {
    const auto* old = std::get_if<scene::HullShape>(&before.shape);
    const auto* now = std::get_if<scene::HullShape>(&after.shape);
    std::vector<Item> points;
    for (const auto& [option, value] : faces.words) {
        const auto items = itemsOf(text_, value.content);
        for (std::size_t i = 0; i < items.size(); ++i)
            if (items[i].value.starts_with("-"))
                ++i; // -color and its value
            else
                points.push_back(items[i]);
    }
    if (old && now && old->points.size() == now->points.size() &&
        points.size() == old->points.size() && before.position == after.position &&
        before.rotation == after.rotation) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (old->points[i] != now->points[i])
                putVector(points[i], now->points[i]);
        return;
    }
    put({faces.words.front().first.range.from, faces.words.front().second.range.to},
        partText(after));
    for (std::size_t i = 1; i < faces.words.size(); ++i)
        removeWhole(faces.words[i]);
}

void Description::change(std::size_t index, const scene::Part& before, const scene::Part& after) {
    const WrittenPart& written = parts_[index];
    if (written.isFaces())
        changeFaces(written, before, after);
    else
        changeSub(written.words.front().second, before, after);
}

// An option and its value of a part, with the space before them; the first without.
void Description::removeWithin(const std::vector<Item>& items, const Item* value) {
    const Item* option = value - 1;
    const std::size_t from = option == items.data() ? option->range.from : (option - 1)->range.to;
    edits_.push_back({{from, value->range.to}, ""});
}

void Description::removeWhole(const std::pair<Item, Item>& words) {
    const auto same = [&](const Item& item) { return item.range == words.first.range; };
    removed_.push_back(
        static_cast<std::size_t>(std::ranges::find_if(items_, same) - items_.begin()));
}

void Description::remove(std::size_t index) {
    for (const auto& words : parts_[index].words)
        removeWhole(words);
}

// Apart from the last as that is from the one before.
void Description::append(const scene::Part& part) {
    std::string space = " ";
    if (items_.size() >= 4) {
        const std::size_t from = items_[items_.size() - 3].range.to;
        space = text_.substr(from, items_[items_.size() - 2].range.from - from);
    }
    appended_ += space + partText(part);
}

// What is removed one after another is one stretch: with the space before it, or at the beginning
// with that after it. What is added comes in the place of a stretch at the end.
text::Edits Description::edits() {
    std::ranges::sort(removed_);
    for (std::size_t i = 0; i < removed_.size();) {
        std::size_t next = i + 1;
        while (next < removed_.size() && removed_[next] == removed_[next - 1] + 2)
            ++next;
        const std::size_t first = removed_[i], last = removed_[next - 1] + 1;
        const bool isLast = last + 1 >= items_.size();
        const std::size_t from = first > 0 ? items_[first - 1].range.to : items_.front().range.from;
        const std::size_t to =
            first > 0 || isLast ? items_[last].range.to : items_[last + 1].range.from;
        edits_.push_back({{from, to}, isLast ? std::exchange(appended_, {}) : ""});
        if (first == 0 && isLast)
            edits_.back().text.erase(0, edits_.back().text.find_first_not_of(" \t\r\n\\"));
        i = next;
    }
    const std::size_t end = items_.empty() ? content_.from : items_.back().range.to;
    if (!appended_.empty())
        edits_.push_back({{end, end}, appended_});
    // What is put in before what is removed or replaced comes first.
    text::putInOrder(edits_);
    return edits_;
}

} // namespace

std::vector<DraftPart> draftOf(const scene::ShapeSet& set) {
    std::vector<DraftPart> draft;
    for (std::size_t i = 0; i < set.parts.size(); ++i)
        draft.push_back({set.parts[i], i});
    return draft;
}

std::string partText(const scene::Part& part) {
    std::string text = "-sub {";
    if (part.position != Vector::Zero())
        text += "-pos " + listText(part.position) + " ";
    if (part.rotation != Vector::Zero())
        text += "-rot " + listText(part.rotation) + " ";
    if (part.appearance.color)
        text += "-color " + colourText(*part.appearance.color) + " ";
    if (part.appearance.shininess)
        text += "-shininess " + numberText(*part.appearance.shininess, 0) + " ";
    if (part.appearance.transparency)
        text += "-transparency " + numberText(*part.appearance.transparency, 0) + " ";
    if (part.density)
        text += "-density " + numberText(*part.density, 0) + " ";
    return text + shapeText(part) + "}";
}

std::string descriptionText(const std::vector<scene::Part>& parts) {
    std::string text = "{";
    for (const scene::Part& part : parts)
        text += (parts.size() > 1 ? "\n    " : "") + partText(part);
    return text + (parts.size() > 1 ? "\n}" : "}");
}

std::string shapeSetText(const std::string& name, const std::vector<scene::Part>& parts) {
    return "shape_set " + name + " -desc " + descriptionText(parts) + "\n";
}

Answer become(const std::string& text, std::shared_ptr<const scene::Scene> scene,
              std::size_t shapeSet, const std::vector<DraftPart>& draft) {
    const scene::ShapeSet& set = scene->shapeSets[shapeSet];
    const std::string subject = "-desc of shape set \"" + set.name + "\" ";
    Answer answer;
    if (draft.empty()) {
        answer.reason = "A shape set has one part at least; the shape set itself can be deleted.";
        return answer;
    }
    const script::Structure structure = script::structureOf(text);
    const Origins origins(text, structure, *scene);
    const script::Command* command =
        set.source.command.known() ? structure.startingAt(set.source.command.from) : nullptr;
    if (!command || set.source.runs != 1) {
        answer.reason = subject + "is made by the command of line " +
                        std::to_string(set.source.line) +
                        (command ? ", which makes several." : ", which is not in the text.");
        answer.cause = set.source.command;
        return answer;
    }
    for (const scene::Argument& argument : set.source.arguments)
        for (const script::Word& word : command->words) {
            if (argument.option != "-desc" || !(word.range == argument.word))
                continue;
            const Origins::Literal literal = origins.literalOf(*command, word);
            if (!literal.content.known()) {
                std::vector<scene::Part> parts;
                parts.reserve(draft.size());
                for (const DraftPart& one : draft)
                    parts.push_back(one.part);
                answer.reason = subject + literal.reason + ".";
                answer.cause = literal.cause;
                answer.offers = {{"Write the parts of " + set.name + " out",
                                  {{word.range.from, word.range.to, descriptionText(parts)}}}};
                return answer;
            }
            Description written(text, literal.content);
            if (written.parts().size() != set.parts.size()) {
                answer.reason = subject + "is not written as its parts.";
                answer.cause = word.range;
                return answer;
            }
            for (std::size_t i = 0; i < set.parts.size(); ++i) {
                const auto now =
                    std::ranges::find_if(draft, [&](const DraftPart& one) { return one.was == i; });
                if (now == draft.end())
                    written.remove(i);
                else if (!(now->part == set.parts[i]))
                    written.change(i, set.parts[i], now->part);
            }
            for (const DraftPart& one : draft)
                if (!one.was)
                    written.append(one.part);
            answer.edits = written.edits();
            return answer;
        }
    answer.reason = subject + "is not in the text.";
    answer.cause = set.source.command;
    return answer;
}

namespace {

// Of a body the shape: by -shape, or the second word that has no option.
const scene::Argument* shapeWordOf(const scene::Body& body) {
    const scene::Argument* byPlace = nullptr;
    for (const scene::Argument& one : body.source.arguments) {
        if (one.option == "-shape")
            return &one;
        if (one.option.empty())
            byPlace = &one;
    }
    return byPlace;
}

} // namespace

Answer renamed(const std::string& text, const scene::Scene& scene, std::size_t shapeSet,
               const std::string& name) {
    const scene::ShapeSet& set = scene.shapeSets[shapeSet];
    Answer answer;
    const auto rename = [&](const scene::Argument* word, const std::string& what) {
        if (!answer.reason.empty())
            return;
        if (!word || !word->literal || !word->word.known() || word->word.to > text.size()) {
            answer.reason = what + " is computed; its name can be changed in the text.";
            answer.cause = word ? word->word : scene::Range{};
            return;
        }
        const text::Edit edit{{word->word.from, word->word.to}, name};
        if (std::ranges::find(answer.edits, edit) == answer.edits.end())
            answer.edits.push_back(edit);
    };
    const auto own = std::ranges::find(set.source.arguments, "", &scene::Argument::option);
    rename(own == set.source.arguments.end() ? nullptr : &*own,
           "The name of shape set \"" + set.name + "\"");
    for (const scene::Body& body : scene.bodies)
        if (body.shape == set.name)
            rename(shapeWordOf(body), "The shape of body \"" + body.name + "\" in line " +
                                          std::to_string(body.source.line));
    text::putInOrder(answer.edits);
    if (!answer.reason.empty())
        answer.edits.clear();
    return answer;
}

} // namespace editing
