"""A page of results that opens anywhere: data.py chooses what it shows, page.py writes it, viewer/ draws it."""
