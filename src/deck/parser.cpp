#include "deck/parser.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "deck/card_builder.hpp"
#include "deck/card_order.hpp"
#include "deck/card_reader.hpp"
#include "deck/cards/card_lists.hpp"
#include "deck/cut_group.hpp"
#include "deck/deck_text.hpp"
#include "deck/known_materials.hpp"
#include "text/capitals.hpp"
#include "text/suggest.hpp"

namespace blocks::deck {
namespace {

constexpr std::size_t title_length = 80;

class Parser {
 public:
  Parser(Deck& deck, std::vector<Line> lines, std::vector<OverrideFields> overrides,
         Diagnostics& diagnostics)
      : deck_(deck), lines_(std::move(lines)), overrides_(std::move(overrides)),
        diagnostics_(&diagnostics), order_(names(lines_), diagnostics) {}

  void run();
  /// Parses cards that follow a deck that was read before.
  void run_on();

 private:
  /// Returns the card that a keyword means, even if misspelt; null if no card is near.
  static const CardSpec* meant(const Line& line);
  static std::vector<std::string_view> names(const std::vector<Line>& lines);
  /// Returns the first value of a card if it is a whole number.
  static std::optional<long> first_number(const Line& line);
  long max_new_blocks(const CardSpec& spec, std::optional<long> number) const;

  bool more() const { return next_ < lines_.size(); }
  /// Takes the lines of values up to the next keyword.
  std::vector<Line> take_data();

  void card(const CardSpec& spec, bool misspelt);
  void unknown(const Line& line);
  void finish(const CardSpec& spec, Card card, SourceLocation where);
  void part_of_group(const CutGroup::Part& part, bool in_place);
  void check_loop(const CardSpec* next);
  void check_unused_overrides();

  bool title(Start& card, const Line& line);
  bool lists(Card& card, const std::vector<Line>& data, SourceLocation end) {
    return read_lists(card, data, end, maxima_, *diagnostics_);
  }

  Deck& deck_;
  std::vector<Line> lines_;
  std::vector<OverrideFields> overrides_;
  Diagnostics* diagnostics_;  ///< never null
  CardOrder order_;
  std::size_t next_ = 0;
  bool stopped_ = false;
  StartMaxima maxima_;
  KnownMaterials materials_;
  std::map<std::string_view, long> met_;  ///< number of cards of each kind so far
  std::optional<Cloop> loop_;  ///< a CLOOP whose CREATE has not been read yet
  std::optional<SourceLocation> loop_at_;
  CutGroup group_;
};

const CardSpec* Parser::meant(const Line& line) {
  if (line.is_data()) {
    return nullptr;
  }
  const std::string& word = line.fields.front().text;
  if (const CardSpec* spec = find_card(word)) {
    return spec;
  }
  return find_card(text::suggest(word, card_names()));
}

std::vector<std::string_view> Parser::names(const std::vector<Line>& lines) {
  std::vector<std::string_view> out;
  for (const Line& line : lines) {
    if (const CardSpec* spec = meant(line)) {
      out.push_back(spec->name);
      if (spec->name == "STOP") {
        break;
      }
    }
  }
  return out;
}

std::optional<long> Parser::first_number(const Line& line) {
  if (line.fields.size() < 2) {
    return std::nullopt;
  }
  Diagnostics ignored("", "");
  const FieldSpec whole{"", Kind::integer, {}, {}, "", ""};
  const Value value = read_value(line.fields[1], whole, "", ignored);
  return value.ok && value.given ? std::optional(value.integer) : std::nullopt;
}

std::vector<Line> Parser::take_data() {
  const std::size_t begin = next_;
  while (more() && lines_[next_].is_data()) {
    ++next_;
  }
  return {lines_.begin() + static_cast<long>(begin),
          lines_.begin() + static_cast<long>(next_)};
}

void Parser::run() {
  if (more() && lines_.front().is_data()) {
    diagnostics_->error(lines_.front().fields.front().where, "",
                        "the deck must begin with a card, found values",
                        "a new run begins with START, nblok, ncmx and a title line");
    take_data();
  }
  while (more() && !stopped_) {
    if (const CardSpec* spec = find_card(lines_[next_].fields.front().text)) {
      card(*spec, false);
    } else {
      unknown(lines_[next_]);
    }
  }
  check_loop(nullptr);
  group_.end_before({}, *diagnostics_);
  SourceLocation end{1, 1, 1};
  if (!lines_.empty()) {
    const Line& last = stopped_ ? lines_[next_ - 1] : lines_.back();
    end = last.title ? last.title_where : last.end;
  }
  order_.finish(end);
  if (more()) {
    diagnostics_->warning(lines_[next_].fields.front().where, "STOP",
                          "text after STOP is ignored");
  }
  check_unused_overrides();
}

void Parser::run_on() {
  order_.begin_after_deck();
  run();
}

void Parser::unknown(const Line& line) {
  const Field& word = line.fields.front();
  const CardSpec* spec = meant(line);
  std::string hint = "'blocks cards' lists all cards";
  if (spec != nullptr) {
    hint = fmt::format("did you mean {}?", spec->name);
  } else if (is_comment_of_fortran(word.text)) {
    hint = comment_hint;
  } else if (text::capitals(word.text) == "RANDOM") {
    hint = "RANDOM is the last value of the LAYER card";
  }
  diagnostics_->error(word.where, "", fmt::format("unknown card {}", shown(word.text)),
                      hint);
  check_loop(spec);
  if (spec != nullptr) {
    // The card is read as the one it means. Its other faults are not reported, because
    // the guess may be wrong.
    Diagnostics ignored("", "");
    Diagnostics* const shown_ones = std::exchange(diagnostics_, &ignored);
    card(*spec, true);
    diagnostics_ = shown_ones;
    return;
  }
  loop_at_.reset();
  loop_.reset();
  group_.unknown();
  ++next_;
  const bool has_lines = !take_data().empty();  // so it may be a CREATE or LAYER
  deck_.unread.push_back({word.where, "", first_number(line),
                          has_lines ? UnreadCard::any_number_of_blocks : 0});
}

/// The number of blocks that a faulty card may have made at most. A faulty CLOOP,
/// ORIENT or MERGE changes the number of blocks of later cards.
long Parser::max_new_blocks(const CardSpec& spec, std::optional<long> number) const {
  constexpr long any = UnreadCard::any_number_of_blocks;
  if (spec.name == "CREATE") {
    return loop_ ? std::min(loop_->nloop.value, any) : 1;
  }
  if (spec.name == "LAYER") {
    return number ? std::abs(std::clamp(*number, -any, any)) : any;
  }
  const bool counts = spec.name == "READ9" || spec.name == "CLOOP" ||
                      spec.name == "ORIENT" || spec.name == "MERGE" ||
                      spec.name == "RESTART" || CutGroup::has(spec.name);
  return counts ? any : 0;
}

/// Reports a CLOOP that is not directly followed by CREATE.
void Parser::check_loop(const CardSpec* next) {
  if (loop_at_ && (next == nullptr || next->name != "CREATE")) {
    diagnostics_->error(*loop_at_, "CLOOP", "must be directly followed by CREATE",
                        "CLOOP repeats the CREATE card that follows it");
    loop_at_.reset();
    loop_.reset();
  }
}

void Parser::card(const CardSpec& spec, bool misspelt) {
  const Line line = take_card(spec, lines_, next_);
  const SourceLocation where = line.fields.front().where;
  check_loop(&spec);
  const bool in_place = order_.pass(spec, where, misspelt);
  const Values values =
      read_card(spec, line, ++met_[spec.name], overrides_, *diagnostics_);
  stopped_ = spec.name == "STOP";
  // Lines after STOP belong to no card.
  const std::vector<Line> data = stopped_ ? std::vector<Line>{} : take_data();
  if (CutGroup::has(spec.name)) {
    part_of_group({spec.name, where, values, data, line.end}, in_place);
    return;
  }
  group_.end_before(spec.name, *diagnostics_);

  if (spec.name == "CLOOP") {
    if (!misspelt) {
      loop_at_ = where;
    }
    if (values.ok) {
      loop_ = Cloop{values.fields[0].as_int(), values.fields[1].as_exact(),
                    values.fields[2].as_exact()};
    }
  }
  std::optional<Card> built = build_card(spec.name, values, *diagnostics_);
  if (spec.name == "START") {
    Start untold;
    if (values.ok) {
      maxima_.blocks = values.fields[0].integer;
      maxima_.corners = values.fields[1].integer;
    }
    if (!title(built ? std::get<Start>(*built) : untold, line)) {
      built.reset();
    }
  }
  if (!data.empty() && spec.follow_on.empty()) {
    // After a faulty card the lines may be part of the same mistake.
    if (values.ok) {
      const Field& first = data.front().fields.front();
      diagnostics_->error(first.where, std::string(spec.name),
                          "unexpected line of values after this card",
                          first.text.starts_with('*') ? comment_hint
                                                      : "syntax: " + spec.syntax());
    }
    built.reset();
  } else if (spec.name == "START" && !data.empty()) {
    diagnostics_->error(data.front().fields.front().where, "START",
                        "unexpected line of values after the title",
                        "the title is one line");
    built.reset();
  } else if (!spec.follow_on.empty() && spec.name != "START") {
    // The lists can be checked even if another field of the card is faulty, because
    // their count is known.
    if (!built && values.fields[0].ok && spec.name == "CREATE") {
      Card counted = Create{.nc = values.fields[0].as_int(),
                            .mat = {},
                            .ifix = {},
                            .x = {},
                            .y = {},
                            .loop = {}};
      lists(counted, data, line.end);
    } else if (built && !lists(*built, data, line.end)) {
      built.reset();
    }
  }
  // What a guess does to blocks matters for later cards. Nothing else may follow from
  // it.
  const bool only_guessed = misspelt && spec.group == CardGroup::problem &&
                            max_new_blocks(spec, first_number(line)) == 0;
  if (built && in_place && !only_guessed) {
    finish(spec, std::move(*built), where);
  } else if (spec.name != "CLOOP" || !values.ok) {
    const bool sound = !values.fields.empty() && values.fields.front().ok;
    const std::optional<long> number = sound ? first_number(line) : std::nullopt;
    deck_.unread.push_back(
        {where, std::string(spec.name), number, max_new_blocks(spec, number)});
  }
  if (spec.name != "CLOOP") {
    loop_.reset();
    loop_at_.reset();
  }
}

void Parser::part_of_group(const CutGroup::Part& part, bool in_place) {
  loop_at_.reset();
  loop_.reset();
  std::optional<Cut> cut = group_.take(part, *diagnostics_);
  if (cut && in_place)
    deck_.commands.push_back({part.where, std::string(part.name), std::move(*cut)});
  else if (cut || part.name == "CUT" || !part.values.ok)
    deck_.unread.push_back({part.where, std::string(part.name), std::nullopt,
                            UnreadCard::any_number_of_blocks});
}

/// Adds a card without faults to the deck.
void Parser::finish(const CardSpec& spec, Card card, SourceLocation where) {
  if (auto* create = std::get_if<Create>(&card)) {
    create->loop = loop_;
  } else if (const auto* material = std::get_if<Material>(&card)) {
    if (!materials_.add(*material, *diagnostics_)) {
      return;
    }
  }
  deck_.commands.push_back({where, std::string(spec.name), std::move(card)});
}

bool Parser::title(Start& card, const Line& line) {
  if (!line.title) {
    diagnostics_->error(line.end, "START", "the title line is missing",
                        "the line after START is the title of the problem");
    return false;
  }
  card.title = *line.title;
  const auto length = static_cast<std::size_t>(line.title_where.length);
  if (length > title_length) {
    diagnostics_->warning(
        {line.title_where.line, static_cast<int>(title_length) + 1,
         static_cast<int>(length - title_length)},
        "START",
        fmt::format("the title has {} characters, the report allows 80", length),
        "it is kept in full");
  }
  const Line as_card = split_fields(*line.title, line.title_where.line);
  if (!as_card.fields.empty() && line.title->find(',') != std::string::npos) {
    const Field& word = as_card.fields.front();
    if (find_card(word.text) != nullptr) {
      diagnostics_->warning(
          word.where, "START",
          fmt::format("the title looks like the card {}", text::capitals(word.text)),
          "the line after START is always the title");
    }
  }
  return true;
}

/// Reports overrides that changed nothing; they would be silent mistakes.
void Parser::check_unused_overrides() {
  for (const OverrideFields& set : overrides_) {
    const long cards = met_[set.card];
    const SourceLocation where = set.fields.front().where;
    if (cards == 0) {
      diagnostics_->error(where, set.card,
                          "the deck has no such card, so --set cannot change it",
                          "add the card to the deck");
    } else if (set.number > cards) {
      diagnostics_->error(
          where, set.card,
          fmt::format("the deck has {} {} card{}, no {}[{}]", cards, set.card,
                      cards == 1 ? "" : "s", set.card, set.number),
          fmt::format("write {}{}; blocks cards --set DECK lists what can be set",
                      set.card, cards == 1 ? "" : fmt::format("[1] to [{}]", cards)));
    }
  }
}

}  // namespace

Deck parse(const std::string& file, const std::string& text, Diagnostics& diagnostics,
           const std::vector<Override>& overrides) {
  Deck deck{file, text, {}, {}};
  std::vector<OverrideFields> fields = prepare_overrides(overrides, diagnostics);
  if (!is_deck_text(text, diagnostics)) {
    return deck;
  }
  std::vector<Line> lines = split_deck(text);
  if (lines.empty()) {
    diagnostics.error({1, 1, 1}, "", "the deck is empty",
                      "a new run begins with START, nblok, ncmx and a title line");
  } else {
    Parser(deck, std::move(lines), std::move(fields), diagnostics).run();
  }
  return deck;
}

Deck parse_further(const std::string& file, const std::string& text,
                   Diagnostics& diagnostics) {
  Deck deck{file, text, {}, {}};
  if (is_deck_text(text, diagnostics)) {
    Parser(deck, split_deck(text), {}, diagnostics).run_on();
  }
  return deck;
}

}  // namespace blocks::deck
