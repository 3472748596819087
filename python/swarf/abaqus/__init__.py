"""swarf import: a deck from a model that was written for Abaqus."""
