#!/usr/bin/python3
"""Writes what services would publish about the campus in sample/: menus/*.json (OpenMensa) and
transport/erlenhof.zip (GTFS). The same call writes the same bytes.

    make_sample.py [MONDAY]      of the first of two weeks of menus; else 2026-11-23
"""
import datetime
import io
import json
import pathlib
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent / "sample"

MEALS = {  # English, German, category, price for students, notes
    "main": [
        ("Chicken curry with rice", "Hähnchencurry mit Reis", 3.20, []),
        ("Beef goulash with noodles", "Rindergulasch mit Nudeln", 3.60, []),
        ("Fried fish with potato salad", "Backfisch mit Kartoffelsalat", 3.40, ["fish"]),
        ("Pork schnitzel with chips", "Schweineschnitzel mit Pommes frites", 3.50, []),
        ("Turkey steak with vegetables", "Putensteak mit Gemüse", 3.80, []),
    ],
    "veggie": [
        ("Vegetable lasagne", "Gemüselasagne", 2.60, ["vegetarian"]),
        ("Chickpea stew with flat bread", "Kichererbseneintopf mit Fladenbrot", 2.20, ["vegan"]),
        ("Cheese dumplings with spinach", "Käseknödel mit Spinat", 2.80, ["vegetarian"]),
        ("Lentil bolognese", "Linsenbolognese", 2.40, ["vegan"]),
        ("Mushroom risotto", "Pilzrisotto", 2.70, ["vegetarian"]),
    ],
    "soup": [
        ("Tomato soup", "Tomatensuppe", 1.10, ["vegan"]),
        ("Potato soup with sausage", "Kartoffelsuppe mit Würstchen", 1.60, []),
        ("Pumpkin soup", "Kürbissuppe", 1.10, ["vegan"]),
        ("Chicken broth", "Hühnerbrühe", 1.30, []),
        ("Carrot and ginger soup", "Möhren-Ingwer-Suppe", 1.10, ["vegan"]),
    ],
}
CATEGORIES = {"main": ("Main course", "Tellergericht"), "veggie": ("Daily veggie", "Veggie"),
              "soup": ("Soup", "Suppe")}
NOTES = {"vegetarian": ("vegetarian", "vegetarisch"), "vegan": ("vegan", "vegan"),
         "fish": ("fish", "Fisch")}


def menu(first, language):
    days = []
    for number in range(14):
        date = first + datetime.timedelta(number)
        meals = []
        for key, dishes in MEALS.items() if date.weekday() < 5 else ():
            week, day = divmod(number, 7)
            dish = dishes[(day + 2 * week) % 5]
            meals.append({"id": 10 * number + len(meals), "name": dish[language],
                          "category": CATEGORIES[key][language],
                          "prices": {"students": dish[2], "employees": round(dish[2] + 1.5, 2),
                                     "pupils": None, "others": round(dish[2] + 2.5, 2)},
                          "notes": [NOTES[note][language] for note in dish[3]]})
        days.append({"date": date.isoformat(), "closed": date.weekday() >= 5, "meals": meals})
    return json.dumps(days, ensure_ascii=False, indent=1) + "\n"


STOPS = {  # id: name, station that it belongs to
    "campus": ("Erlenhof Campus", ""), "campus_a": ("Erlenhof Campus", "campus"),
    "campus_b": ("Erlenhof Campus", "campus"), "techpark": ("Technologiepark", ""),
    "market": ("Marktplatz", ""), "central": ("Hauptbahnhof", ""), "clinic": ("Klinikum", ""),
    "north": ("Nordpark", ""), "airport": ("Flughafen", ""), "fair": ("Messegelände", ""),
    "lake": ("Erlensee", ""), "zoo": ("Zoologischer Garten", ""),
}
LINES = {  # line: type of vehicle (0 tram, 2 train, 3 bus), stops with minutes from the first
    "4": (0, [("lake", 0), ("campus_a", 6), ("clinic", 10), ("market", 15), ("central", 20)]),
    "5": (0, [("fair", 0), ("campus_a", 9), ("market", 17), ("zoo", 22)]),
    "120": (3, [("techpark", 0), ("campus_b", 4), ("north", 12), ("airport", 31)]),
    "133": (3, [("techpark", 0), ("clinic", 8), ("central", 19)]),
    "N4": (3, [("central", 0), ("market", 4), ("campus_b", 13), ("lake", 19)]),
    "S3": (2, [("techpark", 0), ("fair", 5), ("airport", 14)]),
}
DAY = {"4": (5 * 60, 24 * 60 + 20, 10), "5": (5 * 60 + 5, 23 * 60, 15),
       "120": (6 * 60, 22 * 60, 20), "133": (6 * 60 + 10, 20 * 60, 30),
       "S3": (5 * 60 + 30, 24 * 60, 30)}  # first, last, every, on weekdays
NIGHT = {"N4": (24 * 60 + 30, 28 * 60 + 30, 60)}  # after midnight, of the day before
BACK = ("4", "5", "120", "133", "S3")  # lines that also run the other way


def clock(minutes):
    return f"{minutes // 60:02}:{minutes % 60:02}:00"


def trips():
    """(line, service, number, stops with times)"""
    for service, factor, lines in (("weekday", 1, DAY), ("weekend", 2, DAY), ("night", 1, NIGHT)):
        for line, (first, last, every) in lines.items():
            for way in (0, 1) if line in BACK else (0,):
                stops = LINES[line][1]
                if way:
                    stops = [(stop, stops[-1][1] - at) for stop, at in reversed(stops)]
                starts = range(first + 3 * way, last + 1, every * factor)
                for number, start in enumerate(starts):
                    yield line, service, f"{way}{number:03}", [(s, start + at) for s, at in stops]


def tables():
    yield "agency.txt", ["agency_id,agency_name,agency_url,agency_timezone",
                         "ev,Erlenhofer Verkehrsbetriebe,https://transport.example,Europe/Berlin"]
    yield "stops.txt", ["stop_id,stop_name,stop_lat,stop_lon,location_type,parent_station"] + [
        f"{id},{name},52.0,9.0,{int(id == 'campus')},{parent}"
        for id, (name, parent) in STOPS.items()]
    yield "routes.txt", ["route_id,agency_id,route_short_name,route_long_name,route_type"] + [
        f"r{line},ev,{line},,{kind}" for line, (kind, _) in LINES.items()]
    yield "calendar.txt", [
        "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date",
        "weekday,1,1,1,1,1,0,0,20250101,20351231", "weekend,0,0,0,0,0,1,1,20250101,20351231",
        "night,0,0,0,0,1,1,0,20250101,20351231"]
    holidays = ("20261225", "20270101", "20270326", "20270329")
    yield "calendar_dates.txt", ["service_id,date,exception_type"] + [
        f"{service},{day},{kind}" for day in holidays
        for service, kind in (("weekday", 2), ("weekend", 1))]
    listed = list(trips())
    yield "trips.txt", ["route_id,service_id,trip_id,trip_headsign"] + [
        f"r{line},{service},{line}-{service}-{number},{STOPS[calls[-1][0]][0]}"
        for line, service, number, calls in listed]
    yield "stop_times.txt", ["trip_id,arrival_time,departure_time,stop_id,stop_sequence"] + [
        f"{line}-{service}-{number},{clock(at)},{clock(at)},{stop},{sequence}"
        for line, service, number, calls in listed
        for sequence, (stop, at) in enumerate(calls, 1)]


def feed():
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, lines in tables():
            info = zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, "\r\n".join(lines) + "\r\n")
    return buffer.getvalue()


def main():
    if len(sys.argv) > 2 or sys.argv[1:] in (["--help"], ["-h"]):
        sys.exit(__doc__)
    first = datetime.date.fromisoformat(sys.argv[1] if sys.argv[1:] else "2026-11-23")
    for number, language in enumerate(("en", "de")):
        (HERE / f"menus/canteen.{language}.json").write_text(menu(first, number))
    (HERE / "transport/erlenhof.zip").write_bytes(feed())


if __name__ == "__main__":
    main()
