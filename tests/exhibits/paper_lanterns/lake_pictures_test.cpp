// Pictures.
