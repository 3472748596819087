// A new section of a deck, from the rows of its keys.
#include "src/deck/section.hpp"

namespace swarf {
namespace {

template <class Section>
void set_defaults(const Keys<Section>& keys, Section& section) {
  clear_fields(keys, section);
  fill_defaults(keys, section);
}

} // namespace

MaterialDeck::MaterialDeck(Law its) {
  clear_fields(material_keys(), *this);
  law = its;
  fill_defaults(material_keys(), *this);
}

FaceDeck::FaceDeck(std::string name, FaceKind its, const Triple& speed) : face(std::move(name)), kind(its) {
  set_defaults(face_keys(), *this);
  velocity = speed;
}

BodyDeck::BodyDeck(BodyShape its_shape, Fill its_fill) {
  clear_fields(body_keys(), *this);
  shape = its_shape, fill = its_fill;
  fill_defaults(body_keys(), *this);
}

ToolDeck::ToolDeck(ToolKind its) {
  clear_fields(tool_keys(), *this);
  kind = its;
  fill_defaults(tool_keys(), *this);
}

ContactDeck::ContactDeck() { set_defaults(contact_keys(), *this); }
ParticlesDeck::ParticlesDeck() { set_defaults(particles_keys(), *this); }
HexesDeck::HexesDeck() { set_defaults(hexes_keys(), *this); }
SleepDeck::SleepDeck() { set_defaults(sleep_keys(), *this); }
RunDeck::RunDeck() { set_defaults(run_keys(), *this); }
OutputDeck::OutputDeck() { set_defaults(output_keys(), *this); }
WindowsDeck::WindowsDeck() { set_defaults(windows_keys(), *this); }
MechanisticDeck::MechanisticDeck() { set_defaults(mechanistic_keys(), *this); }
Deck::Deck() { set_defaults(top_keys(), *this); }

} // namespace swarf
