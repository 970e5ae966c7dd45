#include "typography/tokens.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace typography {

namespace {

using Word = std::u16string_view;

// Of the international system with its usual prefixes, and what stands beside it every day. Not
// "in": it is a word.
constexpr std::array units{
    Word(u"m"),    Word(u"km"),  Word(u"dm"),   Word(u"cm"),   Word(u"mm"),   Word(u"µm"),
    Word(u"μm"),   Word(u"nm"),  Word(u"pm"),   Word(u"g"),    Word(u"kg"),   Word(u"mg"),
    Word(u"µg"),   Word(u"μg"),  Word(u"t"),    Word(u"s"),    Word(u"ms"),   Word(u"µs"),
    Word(u"μs"),   Word(u"ns"),  Word(u"min"),  Word(u"h"),    Word(u"d"),    Word(u"Hz"),
    Word(u"kHz"),  Word(u"MHz"), Word(u"GHz"),  Word(u"THz"),  Word(u"N"),    Word(u"kN"),
    Word(u"mN"),   Word(u"MN"),  Word(u"J"),    Word(u"kJ"),   Word(u"MJ"),   Word(u"GJ"),
    Word(u"mJ"),   Word(u"W"),   Word(u"kW"),   Word(u"MW"),   Word(u"GW"),   Word(u"mW"),
    Word(u"kWh"),  Word(u"Wh"),  Word(u"MWh"),  Word(u"GWh"),  Word(u"TWh"),  Word(u"V"),
    Word(u"kV"),   Word(u"mV"),  Word(u"A"),    Word(u"mA"),   Word(u"µA"),   Word(u"kA"),
    Word(u"Ω"),    Word(u"kΩ"),  Word(u"MΩ"),   Word(u"F"),    Word(u"nF"),   Word(u"pF"),
    Word(u"µF"),   Word(u"mF"),  Word(u"H"),    Word(u"mH"),   Word(u"C"),    Word(u"T"),
    Word(u"mT"),   Word(u"Wb"),  Word(u"S"),    Word(u"Pa"),   Word(u"hPa"),  Word(u"kPa"),
    Word(u"MPa"),  Word(u"GPa"), Word(u"bar"),  Word(u"mbar"), Word(u"atm"),  Word(u"K"),
    Word(u"mK"),   Word(u"°"),   Word(u"°C"),   Word(u"°F"),   Word(u"%"),    Word(u"‰"),
    Word(u"ppm"),  Word(u"rad"), Word(u"mrad"), Word(u"deg"),  Word(u"sr"),   Word(u"mol"),
    Word(u"mmol"), Word(u"l"),   Word(u"L"),    Word(u"ml"),   Word(u"mL"),   Word(u"cl"),
    Word(u"dl"),   Word(u"hl"),  Word(u"ha"),   Word(u"cd"),   Word(u"lm"),   Word(u"lx"),
    Word(u"Bq"),   Word(u"Gy"),  Word(u"Sv"),   Word(u"eV"),   Word(u"keV"),  Word(u"MeV"),
    Word(u"GeV"),  Word(u"u"),   Word(u"dB"),   Word(u"cal"),  Word(u"kcal"), Word(u"pt"),
    Word(u"px"),   Word(u"em"),  Word(u"dpi"),  Word(u"ft"),   Word(u"yd"),   Word(u"mi"),
    Word(u"mph"),  Word(u"kn"),  Word(u"oz"),   Word(u"lb"),   Word(u"lbs"),  Word(u"rpm"),
    Word(u"B"),    Word(u"kB"),  Word(u"MB"),   Word(u"GB"),   Word(u"TB"),   Word(u"KiB"),
    Word(u"MiB"),  Word(u"GiB"), Word(u"TiB"),  Word(u"bit"),  Word(u"kbit"), Word(u"Mbit"),
    Word(u"Gbit"), Word(u"€"),   Word(u"$"),    Word(u"£"),    Word(u"EUR"),  Word(u"USD"),
    Word(u"GBP"),  Word(u"CHF"), Word(u"am"),   Word(u"pm"),   Word(u"a.m."), Word(u"p.m."),
    Word(u"Uhr")};

constexpr std::array months{
    Word(u"January"),  Word(u"February"), Word(u"March"),    Word(u"April"),     Word(u"May"),
    Word(u"June"),     Word(u"July"),     Word(u"August"),   Word(u"September"), Word(u"October"),
    Word(u"November"), Word(u"December"), Word(u"Jan"),      Word(u"Feb"),       Word(u"Mar"),
    Word(u"Apr"),      Word(u"Jun"),      Word(u"Jul"),      Word(u"Aug"),       Word(u"Sep"),
    Word(u"Sept"),     Word(u"Oct"),      Word(u"Nov"),      Word(u"Dec"),       Word(u"Januar"),
    Word(u"Jänner"),   Word(u"Februar"),  Word(u"März"),     Word(u"Mai"),       Word(u"Juni"),
    Word(u"Juli"),     Word(u"Oktober"),  Word(u"Dezember"), Word(u"Okt"),       Word(u"Dez"),
    Word(u"janvier"),  Word(u"février"),  Word(u"mars"),     Word(u"avril"),     Word(u"mai"),
    Word(u"juin"),     Word(u"juillet"),  Word(u"août"),     Word(u"septembre"), Word(u"octobre"),
    Word(u"novembre"), Word(u"décembre")};

// Without the point of an abbreviation.
constexpr std::array naming{
    Word(u"Figure"),      Word(u"figure"),     Word(u"Figures"),  Word(u"figures"),
    Word(u"Fig"),         Word(u"fig"),        Word(u"Figs"),     Word(u"Table"),
    Word(u"table"),       Word(u"Tables"),     Word(u"tables"),   Word(u"Tab"),
    Word(u"Section"),     Word(u"section"),    Word(u"Sections"), Word(u"Sec"),
    Word(u"sec"),         Word(u"Sect"),       Word(u"Chapter"),  Word(u"chapter"),
    Word(u"Ch"),          Word(u"ch"),         Word(u"Chap"),     Word(u"Appendix"),
    Word(u"appendix"),    Word(u"Equation"),   Word(u"equation"), Word(u"Equations"),
    Word(u"Eq"),          Word(u"eq"),         Word(u"Eqs"),      Word(u"Eqn"),
    Word(u"Page"),        Word(u"page"),       Word(u"pages"),    Word(u"p"),
    Word(u"pp"),          Word(u"Line"),       Word(u"line"),     Word(u"lines"),
    Word(u"Step"),        Word(u"step"),       Word(u"Item"),     Word(u"item"),
    Word(u"Part"),        Word(u"part"),       Word(u"Volume"),   Word(u"volume"),
    Word(u"Vol"),         Word(u"vol"),        Word(u"Number"),   Word(u"number"),
    Word(u"No"),          Word(u"no"),         Word(u"Nos"),      Word(u"Footnote"),
    Word(u"footnote"),    Word(u"Example"),    Word(u"example"),  Word(u"Theorem"),
    Word(u"Lemma"),       Word(u"Definition"), Word(u"Exercise"), Word(u"Version"),
    Word(u"version"),     Word(u"Slide"),      Word(u"slide"),    Word(u"Abbildung"),
    Word(u"Abbildungen"), Word(u"Abb"),        Word(u"Bild"),     Word(u"Tabelle"),
    Word(u"Tabellen"),    Word(u"Abschnitt"),  Word(u"Abschn"),   Word(u"Kapitel"),
    Word(u"Kap"),         Word(u"Gleichung"),  Word(u"Gl"),       Word(u"Seite"),
    Word(u"Seiten"),      Word(u"S"),          Word(u"Nr"),       Word(u"Nummer"),
    Word(u"Band"),        Word(u"Bd"),         Word(u"Zeile"),    Word(u"Schritt"),
    Word(u"Teil"),        Word(u"Anhang"),     Word(u"Absatz"),   Word(u"Abs"),
    Word(u"Art"),         Word(u"Artikel"),    Word(u"Aufgabe"),  Word(u"Beispiel"),
    Word(u"Satz"),        Word(u"Tableau"),    Word(u"tableau"),  Word(u"Chapitre"),
    Word(u"chapitre"),    Word(u"Équation"),   Word(u"équation"), Word(u"n°"),
    Word(u"N°"),          Word(u"№"),          Word(u"§"),        Word(u"§§"),
    Word(u"#"),           Word(u"€"),          Word(u"$"),        Word(u"£"),
    Word(u"ca"),          Word(u"approx")};

constexpr std::array titles{Word(u"Dr"), Word(u"Prof"), Word(u"Mr"), Word(u"Mrs"), Word(u"Ms"),
                            Word(u"St"), Word(u"Mme"),  Word(u"Fr"), Word(u"Hr"),  Word(u"Sr")};

template <class Words> bool isOneOf(const Words& words, QStringView word) {
    const Word searched(word.utf16(), static_cast<std::size_t>(word.size()));
    return std::ranges::find(words, searched) != words.end();
}

QStringView withoutPoint(QStringView word) {
    return word.size() > 1 && word.back() == '.' ? word.chopped(1) : word;
}

bool endsASentence(QChar sign) {
    return QStringView(u".,;:!?…").contains(sign) || sign.category() == QChar::Punctuation_Close ||
           sign.category() == QChar::Punctuation_FinalQuote || sign == '"' || sign == '\'';
}

} // namespace

bool isDigit(QChar sign) { return sign >= '0' && sign <= '9'; }

bool isDash(QChar sign) { return sign == QChar(0x2013) || sign == QChar(0x2014); }

bool isOperator(QChar sign) { return QStringView(u"=+−×·±≈≠<>≤≥→≡∝").contains(sign); }

QStringView withoutEnd(QStringView word) {
    while (!word.isEmpty() && endsASentence(word.back()))
        word.chop(1);
    return word;
}

QStringView withoutBeginning(QStringView word) {
    const auto begins = [](QChar sign) {
        return sign.category() == QChar::Punctuation_Open ||
               sign.category() == QChar::Punctuation_InitialQuote || sign == '"' || sign == '\'';
    };
    while (!word.isEmpty() && begins(word.front()))
        word = word.sliced(1);
    return word;
}

bool isUnit(QStringView word) {
    if (isOneOf(units, word))
        return true;
    qsizetype end = 0; // of the first of several, without its power
    while (end < word.size() && !QStringView(u"/·*^⁻⁰¹²³⁴⁵⁶⁷⁸⁹").contains(word[end]) &&
           !isDigit(word[end]))
        ++end;
    return isOneOf(units, word.first(end)) || isOneOf(units, withoutEnd(word.first(end)));
}

bool isMonth(QStringView word) { return isOneOf(months, withoutEnd(word)); }

bool namesANumber(QStringView word) { return isOneOf(naming, withoutPoint(word)); }

bool isTitle(QStringView word) {
    return word.endsWith(QChar('.')) ? isOneOf(titles, withoutPoint(word))
                                     : word == u"Mr" || word == u"Mrs" || word == u"Dr";
}

} // namespace typography
