"""A photograph or a scan of a sheet that `handout --stage blank --scan` printed, measured in millimetres.

    a file -- pictures --> grey pictures            JPEG, PNG, each page of a copier's PDF
    a picture -- registering --> RegisteredPage     markers tell number and corners, dots set it straight
    a key -- predicted --> constructions            the right one, other right ways, each mistake
    page, rooms, constructions -- measuring --> PageReading    all corners fitted at once, in mm from the pole

What is measured is judged as any drawing is, by `marking`. Needs the extra `photo`.
"""
