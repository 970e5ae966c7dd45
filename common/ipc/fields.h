// The fields of every message: their names on the wire, and the ranges, lengths and counts that
// they must keep to.
//
// One function per struct, used by the writer and by the reader of wire.cpp (`v` is either).
// v.field: is always sent (an optional one as null) and must be there unless it is optional;
// v.option: may be left out.
#pragma once

#include "ipc/bounds.h"
#include "ipc/messages.h"

#include <limits>

namespace ipc {

struct Range {
    double from = std::numeric_limits<double>::lowest();
    double to = std::numeric_limits<double>::max();
};

inline constexpr Range anyNumber{};
inline constexpr Range natural{0, 9007199254740991.0}; // 2^53 - 1: whole in every JSON reader
inline constexpr Range pixelCount{1, 16384};
inline constexpr Range positiveScale{1.0 / 64, 64};

template <class V> void describe(V& v, SharedMemory& m) {
    v.field("fd", m.fd, {0, 1 << 20});
    v.field("bytes", m.bytes, natural);
}
template <class V> void describe(V& v, Slot& m) {
    v.field("offset", m.offset, natural);
    v.field("stride", m.stride, {4, 16384 * 16});
}
template <class V> void describe(V& v, MenuEntry& m) {
    v.field("id", m.id, longestName);
    v.field("label", m.label, longestLabel);
    v.option("shortcut", m.shortcut, longestName);
    v.option("checkable", m.checkable);
    v.option("checked", m.checked);
    v.option("enabled", m.enabled);
    v.option("scope", m.scope);
    v.option("mode", m.mode);
    v.option("group", m.group, longestLabel);
    v.option("icon", m.icon, longestName);
}
template <class V> void describe(V& v, text::Edit& m) {
    v.field("from", m.range.from, natural);
    v.field("to", m.range.to, natural);
    v.field("text", m.text, longestText);
}
template <class V> void describe(V& v, ScreenArea& m) {
    v.field("x", m.x, {-(1 << 20), 1 << 20});
    v.field("y", m.y, {-(1 << 20), 1 << 20});
    v.field("width", m.width, {1, 1 << 20});
    v.field("height", m.height, {1, 1 << 20});
}
template <class V> void describe(V& v, Presentation& m) {
    v.field("id", m.id, longestName);
    v.field("label", m.label, longestLabel);
}
template <class V> void describe(V& v, ParameterValue& m) {
    v.field("name", m.name, longestName);
    v.field("value", m.value, anyNumber);
    v.field("min", m.min, anyNumber);
    v.field("max", m.max, anyNumber);
    v.option("label", m.label, longestLabel);
    v.option("unit", m.unit, longestLabel);
}
template <class V> void describe(V& v, ValueOffer& m) {
    v.field("expression", m.expression, longestExpression);
    v.field("label", m.label, longestLabel);
    v.option("unit", m.unit, longestLabel);
}
template <class V> void describe(V& v, DiagnosticItem& m) {
    v.field("severity", m.severity);
    v.field("line", m.line, natural);
    v.field("column", m.column, natural);
    v.field("endLine", m.endLine, natural);
    v.field("endColumn", m.endColumn, natural);
    v.field("message", m.message, longestSentence);
}

template <class V> void describe(V&, Done&) {}
template <class V> void describe(V& v, Initialized& m) {
    v.field("protocol", m.protocol, natural);
    v.field("name", m.name, longestLabel);
    v.field("version", m.version, longestLabel);
    v.field("capabilities", m.capabilities, mostCapabilities);
    v.field("menus", m.menus, mostEntries);
}
template <class V> void describe(V& v, PreferredSize& m) {
    v.field("width", m.width, {1, 16384});
    v.field("height", m.height, {1, 16384});
}
template <class V> void describe(V& v, Exported& m) {
    v.field("mimeType", m.mimeType, longestName);
    v.field("text", m.text, longestText);
}
template <class V> void describe(V& v, Taken& m) {
    v.field("time", m.time, anyNumber);
    v.option("pixels", m.pixels, longestPicture);
}
template <class V> void describe(V& v, Values& m) {
    v.numbersOrNull("values", m.values, mostExpressions);
    v.option("faults", m.faults, mostValueFaults);
}
template <class V> void describe(V& v, Evaluated& m) { v.field("result", m.result, longestText); }
template <class V> void describe(V& v, AskedField& m) {
    v.field("label", m.label, longestLabel);
    v.field("value", m.value, longestInput);
}
template <class V> void describe(V& v, Way& m) {
    v.field("id", m.id, longestName);
    v.field("label", m.label, longestLabel);
}
template <class V> void describe(V& v, ChangedLine& m) {
    v.field("line", m.line, natural);
    v.field("before", m.before, longestSentence);
    v.field("after", m.after, longestSentence);
}
template <class V> void describe(V& v, Question& m) {
    v.field("title", m.title, longestLabel);
    v.option("note", m.note, longestSentence);
    v.field("fields", m.fields, mostFields);
    v.option("refusal", m.refusal, longestSentence);
    v.option("ways", m.ways, mostWays);
    v.option("tries", m.tries);
    v.option("changes", m.changes, mostChangedLines);
}
template <class V> void describe(V& v, Invoked& m) { v.option("question", m.question); }
template <class V> void describe(V& v, Revised& m) { v.field("revision", m.revision, natural); }

template <class V> void describe(V& v, Initialize& m) {
    v.pair("protocol", m.oldest, m.newest, natural);
    v.field("class", m.documentClass, longestName);
    v.field("mode", m.mode);
    v.field("frames", m.frames);
    v.option("locale", m.locale, longestName);
}
template <class V> void describe(V&, Ping&) {}
template <class V> void describe(V& v, SubdocumentLoad& m) {
    v.field("text", m.text, longestText);
    v.field("revision", m.revision, natural);
    v.option("title", m.title, longestLabel);
}
template <class V> void describe(V& v, SubdocumentEdit& m) {
    v.field("revision", m.revision, natural);
    v.field("edits", m.edits, mostEdits);
    v.option("label", m.label, longestLabel);
}
template <class V> void describe(V& v, SessionRestore& m) {
    v.field("state", m.state, longestText);
    v.option("notice", m.notice, longestSentence);
}
template <class V> void describe(V&, PresentationList&) {}
template <class V> void describe(V& v, PresentationSize& m) {
    v.field("presentation", m.presentation, longestName);
    v.inside("available", [&](auto& inner) {
        inner.field("width", m.availableWidth, {1, 1e6});
        inner.field("height", m.availableHeight, {1, 1e6});
    });
}
template <class V> void describe(V& v, PresentationExport& m) {
    v.field("format", m.format, longestName);
    v.option("accuracy", m.accuracy, {0, 1});
}
template <class V> void describe(V& v, RenditionGeometry& m) {
    v.field("rendition", m.rendition, natural);
    v.field("presentation", m.presentation, longestName);
    v.field("width", m.width, pixelCount);
    v.field("height", m.height, pixelCount);
    v.option("scale", m.scale, positiveScale);
    v.option("slots", m.slots, twoSlots);
}
template <class V> void describe(V& v, RenditionCreate& m) {
    describe(v, static_cast<RenditionGeometry&>(m));
    v.option("state", m.state, longestState);
}
template <class V> void describe(V& v, RenditionDestroy& m) {
    v.field("rendition", m.rendition, natural);
}
template <class V> void describe(V& v, RenditionShow& m) {
    v.field("rendition", m.rendition, natural);
}
template <class V> void describe(V& v, RenditionHide& m) {
    v.field("rendition", m.rendition, natural);
}
template <class V> void describe(V& v, RenditionAck& m) {
    v.field("rendition", m.rendition, natural);
    v.field("serial", m.serial, natural);
}
template <class V> void describe(V& v, Input& m) {
    v.field("rendition", m.rendition, natural);
    v.field("type", m.type);
    v.option("x", m.x, {-1e6, 1e6});
    v.option("y", m.y, {-1e6, 1e6});
    v.option("button", m.button);
    v.option("buttons", m.buttons, mostKeys);
    v.option("modifiers", m.modifiers, mostKeys);
    v.option("dx", m.dx, {-1e4, 1e4});
    v.option("dy", m.dy, {-1e4, 1e4});
    v.option("key", m.key, longestName);
    v.option("text", m.text, longestInput);
}
template <class V> void describe(V& v, RenditionSnapshot& m) {
    v.field("presentation", m.presentation, longestName);
    v.field("width", m.width, pixelCount);
    v.field("height", m.height, pixelCount);
    v.option("scale", m.scale, positiveScale);
    v.field("time", m.time, anyNumber);
    v.option("offset", m.offset, natural);
    v.option("stride", m.stride, {4, 16384 * 16});
    v.option("rendition", m.rendition, natural);
}
template <class V> void describe(V& v, MenuInvoke& m) {
    v.field("id", m.id, longestName);
    v.field("rendition", m.rendition, natural);
    v.option("values", m.values, mostFieldValues);
    v.option("trial", m.isTrial);
    v.option("figure", m.figure);
}
template <class V> void describe(V&, TimePlay&) {}
template <class V> void describe(V&, TimePause&) {}
template <class V> void describe(V& v, TimeSeek& m) { v.field("time", m.time, anyNumber); }
template <class V> void describe(V& v, TimeRate& m) {
    v.field("rate", m.rate, {1e-6, 1e6});
    v.option("loop", m.loop);
}
template <class V> void describe(V&, ParameterList&) {}
template <class V> void describe(V& v, ParameterSet& m) {
    v.field("name", m.name, longestName);
    v.field("value", m.value, anyNumber);
}
template <class V> void describe(V&, ValueList&) {}
template <class V> void describe(V& v, ValueRead& m) {
    v.field("expressions", m.expressions, mostExpressions);
    v.field("time", m.time, anyNumber);
}
template <class V> void describe(V& v, ValueSubscribe& m) {
    v.field("id", m.id, natural);
    v.field("expressions", m.expressions, mostExpressions);
}
template <class V> void describe(V& v, ValueUnsubscribe& m) { v.field("id", m.id, natural); }
template <class V> void describe(V& v, ScriptEvaluate& m) {
    v.field("script", m.script, longestText);
}
template <class V> void describe(V& v, ProgressCancel& m) { v.field("token", m.token, natural); }
template <class V> void describe(V&, Shutdown&) {}
template <class V> void describe(V&, Exit&) {}

template <class V> void describe(V& v, RenditionFrame& m) {
    v.field("rendition", m.rendition, natural);
    v.field("slot", m.slot, {0, 1});
    v.field("serial", m.serial, natural);
    v.field("width", m.width, pixelCount);
    v.field("height", m.height, pixelCount);
    v.option("time", m.time, anyNumber);
    v.option("pixels", m.pixels, longestPicture);
}
template <class V> void describe(V& v, SubdocumentChanged& m) {
    v.field("base", m.base, natural);
    v.field("edits", m.edits, mostEdits);
    v.option("label", m.label, longestLabel);
    v.option("group", m.group, longestName);
}
template <class V> void describe(V&, EditUndo&) {}
template <class V> void describe(V&, EditRedo&) {}
template <class V> void describe(V& v, RenditionState& m) {
    v.field("rendition", m.rendition, natural);
    v.field("state", m.state, longestState);
}
template <class V> void describe(V& v, RenditionCursor& m) {
    v.field("rendition", m.rendition, natural);
    v.field("shape", m.shape);
}
template <class V> void describe(V& v, PresentationResized& m) {
    v.option("presentation", m.presentation, longestName);
}
template <class V> void describe(V& v, WindowsChanged& m) {
    v.field("open", m.open, natural);
    v.option("drafts", m.drafts);
}
template <class V> void describe(V& v, SessionKeep& m) { v.field("state", m.state, longestText); }
template <class V> void describe(V& v, MenuChanged& m) { v.field("menus", m.menus, mostEntries); }
template <class V> void describe(V& v, ValueChanged& m) {
    v.field("id", m.id, natural);
    v.option("time", m.time, anyNumber);
    v.numbersOrNull("values", m.values, mostExpressions);
    v.option("faults", m.faults, mostValueFaults);
}
template <class V> void describe(V& v, TimeChanged& m) {
    v.field("time", m.time, anyNumber);
    v.field("playing", m.playing);
    v.option("rate", m.rate, {1e-6, 1e6});
    v.option("loop", m.loop);
    v.field("start", m.start, anyNumber);
    v.field("finish", m.finish, anyNumber);
    v.field("computed", m.computed, anyNumber);
    v.field("predictable", m.predictable, anyNumber);
    v.option("state", m.state);
    v.option("motion", m.motion, natural);
}
template <class V> void describe(V& v, ProgressBegin& m) {
    v.field("token", m.token, natural);
    v.option("title", m.title, longestLabel);
    v.option("cancellable", m.cancellable);
}
template <class V> void describe(V& v, ProgressReport& m) {
    v.field("token", m.token, natural);
    v.option("fraction", m.fraction, {0, 1});
    v.option("message", m.message, longestSentence);
}
template <class V> void describe(V& v, ProgressEnd& m) {
    v.field("token", m.token, natural);
    v.option("message", m.message, longestSentence);
}
template <class V> void describe(V& v, Diagnostics& m) {
    v.field("revision", m.revision, natural);
    v.field("items", m.items, mostDiagnostics);
}

} // namespace ipc
