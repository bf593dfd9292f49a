"""One file a subject: `PHRASES`, English and Chinese side by side. Only `catalogue` reads them."""
