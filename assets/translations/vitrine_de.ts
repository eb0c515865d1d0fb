<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>vitrine</name>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> (allowed 1 to 175 degrees, in radians)</source>
        <translation> (erlaubt 1 bis 175 Grad, im Bogenmaß)</translation>
    </message>
    <message>
        <source> and %1 more</source>
        <translation> und %1 weitere</translation>
    </message>
    <message>
        <source> and {1} at {2}</source>
        <translation> und {1} bei {2}</translation>
    </message>
    <message>
        <source> at {1} to {2} m</source>
        <translation> bei {1} bis {2} m</translation>
    </message>
    <message>
        <source> frames a second</source>
        <translation> Frames pro Sekunde</translation>
    </message>
    <message>
        <source> GB of memory while it is made and written, and this machine has </source>
        <translation> GB Speicher, während es erzeugt und geschrieben wird, und dieser Rechner hat </translation>
    </message>
    <message>
        <source> GB; ask for no more than </source>
        <translation> GB; verlangen Sie nicht mehr als </translation>
    </message>
    <message>
        <source> of {1}</source>
        <translation> von {1}</translation>
    </message>
    <message>
        <source> pixels takes </source>
        <translation> Pixeln braucht </translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> the reference changes by {1}</source>
        <translation> ändert sich die Referenz um {1}</translation>
    </message>
    <message>
        <source> Unit: {1}</source>
        <translation> Einheit: {1}</translation>
    </message>
    <message>
        <source> within {1} s</source>
        <translation> innerhalb von {1} s</translation>
    </message>
    <message>
        <source> · knee</source>
        <translation> · Knie</translation>
    </message>
    <message>
        <source> · present</source>
        <translation> · jetzt</translation>
    </message>
    <message>
        <source>&quot;### {1}&quot; belongs to a step; write &quot;## Title&quot; of the step above it.</source>
        <translation>„### {=1}“ gehört zu einem Schritt; schreiben Sie darüber „## Titel“ des Schritts.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a limit; type a number above 0, such as %2.</source>
        <translation>„%1“ ist keine Grenze; geben Sie eine Zahl über 0 ein, etwa %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value of “%2”. %3</source>
        <translation>„%1“ ist kein Wert für „%2“. %3</translation>
    </message>
    <message>
        <source>&quot;lights&quot; must be an array: [ ... ]</source>
        <translation>„lights“ muss ein Array sein: [ ... ]</translation>
    </message>
    <message>
        <source>&quot;up&quot; points along the view; give another direction</source>
        <translation>„up“ zeigt entlang der Blickrichtung; geben Sie eine andere Richtung an</translation>
    </message>
    <message>
        <source>&quot;values&quot; is missing; give a file that a job of Vitrine wrote.</source>
        <translation>„values“ fehlt; geben Sie eine Datei an, die ein Auftrag von Vitrine geschrieben hat.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; appears twice; remove one of them.</source>
        <translation>„{=1}“ steht zweimal da; entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; contains itself by way of this; take one of the two out</source>
        <translation>„{=1}“ enthält sich hierdurch selbst; nehmen Sie eines von beiden heraus</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; has {2} numbers.</source>
        <translation>„{=1}“ hat {2} Zahlen.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is missing: this does not describe a lenticular print; give a print, or the JSON beside it.</source>
        <translation>„{=1}“ fehlt: Das beschreibt keinen Linsendruck; geben Sie einen Druck an, oder das JSON daneben.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is missing; export the file again.</source>
        <translation>„{=1}“ fehlt; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is no format of Vitrine; choose a preset.</source>
        <translation>„{=1}“ ist kein Format von Vitrine; wählen Sie ein Preset.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is no metric; correct it there.</source>
        <translation>„{=1}“ ist kein Maß; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is no name of a recording; give one that ends in .mp4, .webm, .gif, .webp or .apng, or frames/%04d.png.</source>
        <translation>„{=1}“ ist kein Name für eine Aufnahme; geben Sie einen an, der auf .mp4, .webm, .gif, .webp oder .apng endet, oder frames/%04d.png.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is no pace; write constant or eased.</source>
        <translation>„{=1}“ ist kein Tempo; schreiben Sie constant oder eased.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is no tour; choose another file.</source>
        <translation>„{=1}“ ist kein Rundgang; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is not a valid value.</source>
        <translation>&quot;{=1}&quot; ist kein gültiger Wert.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is not an option of the motion {2}.</source>
        <translation>&quot;{=1}&quot; ist keine Option der Bewegung {=2}.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is not known and was left out.</source>
        <translation>„{=1}“ ist nicht bekannt und wurde weggelassen.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is one of the sheets that come with the program; choose another name.</source>
        <translation>„{=1}“ ist eine der mitgelieferten Folien; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; is the name of an image and of a buffer</source>
        <translation>„{=1}“ ist der Name eines Bildes und eines Puffers</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; must be an array; export the file again.</source>
        <translation>„{=1}“ muss ein Array sein; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; must be there and be a number; correct it there, or move the file away, and a new list is begun.</source>
        <translation>„{=1}“ muss da sein und eine Zahl sein; korrigieren Sie es dort, oder legen Sie die Datei beiseite, und eine neue Liste wird begonnen.</translation>
    </message>
    <message>
        <source>&quot;{1}&quot; was not taken: {2}</source>
        <translation>„{=1}“ wurde nicht übernommen: {2}</translation>
    </message>
    <message>
        <source>#f80, #ff8800, orange and 1, 0.25, 0 (linear red, green, blue) are.</source>
        <translation>#f80, #ff8800, orange und 1, 0.25, 0 (lineares Rot, Grün, Blau) wären welche.</translation>
    </message>
    <message>
        <source>#rrggbb or r,g,b</source>
        <translation>#rrggbb oder r,g,b</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % %2</source>
        <comment>share of a setting, and its name</comment>
        <translation>%1 % %2</translation>
    </message>
    <message>
        <source>%1 % at least</source>
        <translation>mindestens %1 %</translation>
    </message>
    <message>
        <source>%1 % the setting</source>
        <translation>%1 % die Einstellung</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2-mal)</translation>
    </message>
    <message>
        <source>%1 (%2 times; %3 to %4 with %5 % confidence)</source>
        <translation>%1 (%2-mal; %3 bis %4 mit %5 % Konfidenz)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (current)</source>
        <translation>%1 (jetzt)</translation>
    </message>
    <message>
        <source>%1 alone is used for typing and walking. Add Ctrl or Alt, or use a function key.</source>
        <translation>%1 allein ist zum Tippen und Gehen da. Nehmen Sie Strg oder Alt dazu, oder eine Funktionstaste.</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>%1 gibt es bereits.</translation>
    </message>
    <message>
        <source>%1 B follows the current settings; drag the line between the two.</source>
        <translation>%1 B folgt den jetzigen Einstellungen; ziehen Sie an der Linie zwischen beiden.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: Vitrine opens %2, and its own recordings.</source>
        <translation>%1 kann nicht geöffnet werden: Vitrine öffnet %2 und eigene Aufnahmen.</translation>
    </message>
    <message>
        <source>%1 carries no settings: choose a recording that Vitrine made.</source>
        <translation>%1 enthält keine Einstellungen: Wählen Sie eine Aufnahme, die Vitrine erzeugt hat.</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 (Kopie)</translation>
    </message>
    <message>
        <source>%1 directions of %2 frames, each %3 × %4 pixels.</source>
        <translation>%1 Richtungen zu %2 Frames, jeder %3 × %4 Pixel.</translation>
    </message>
    <message>
        <source>%1 dots : 1 px</source>
        <translation>%1 Punkte : 1 px</translation>
    </message>
    <message>
        <source>%1 frames: %2 to %3 ms, half of them up to %4 ms</source>
        <translation>%1 Frames: %2 bis %3 ms, die Hälfte davon bis %4 ms</translation>
    </message>
    <message>
        <source>%1 has no table of measurements; the Study panel measures its parameters.</source>
        <translation>%1 hat keine Messtabelle; das Bedienfeld „Studie“ misst seine Parameter.</translation>
    </message>
    <message>
        <source>%1 in all views</source>
        <translation>%1 in allen Ansichten</translation>
    </message>
    <message>
        <source>%1 is already used by “%2”. Reassign it?</source>
        <translation>%1 gehört bereits zu „%2“. Neu zuweisen?</translation>
    </message>
    <message>
        <source>%1 is not measured yet.</source>
        <translation>%1 ist noch nicht gemessen.</translation>
    </message>
    <message>
        <source>%1 is shown as “%2”; you can also type that.</source>
        <translation>%1 wird als „%2“ gezeigt; auch das lässt sich eingeben.</translation>
    </message>
    <message>
        <source>%1 is supplied with the exhibit and cannot be renamed. Duplicate it, and rename the copy.</source>
        <translation>%1 gehört zum Exponat und kann nicht umbenannt werden. Duplizieren Sie es, und benennen Sie die Kopie um.</translation>
    </message>
    <message>
        <source>%1 is supplied with the exhibit and cannot be tagged. Duplicate it, and tag the copy.</source>
        <translation>%1 gehört zum Exponat und kann keine Tags bekommen. Duplizieren Sie es, und geben Sie der Kopie Tags.</translation>
    </message>
    <message>
        <source>%1 LPI, %2, %3°</source>
        <translation>%1 LPI, %2, %3°</translation>
    </message>
    <message>
        <source>%1 moves</source>
        <translation>%1 bewegt sich</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 Nothing was changed.</source>
        <translation>%1 Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 settings are drawn.
Their work is compared when all of them are.</source>
        <translation>%1 von %2 Einstellungen sind gezeichnet.
Ihre Arbeit wird verglichen, wenn es alle sind.</translation>
    </message>
    <message>
        <source>%1 of %2 settings are drawn.
Times come when all of them are.</source>
        <translation>%1 von %2 Einstellungen sind gezeichnet.
Zeiten kommen, wenn es alle sind.</translation>
    </message>
    <message numerus="yes">
        <source>%1 over %2, both logarithmic: %n points.</source>
        <translation>
            <numerusform>%1 über %2, beide logarithmisch: %n Punkt.</numerusform>
            <numerusform>%1 über %2, beide logarithmisch: %n Punkte.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 over %2.</source>
        <translation>%1 über %2.</translation>
    </message>
    <message>
        <source>%1 parameters differ</source>
        <translation>%1 Parameter verschieden</translation>
    </message>
    <message>
        <source>%1 passes ran, %2 skipped</source>
        <translation>%1 Passes liefen, %2 ausgelassen</translation>
    </message>
    <message>
        <source>%1 per pixel</source>
        <translation>%1 pro Pixel</translation>
    </message>
    <message>
        <source>%1 pictures</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1 pictures saved, the last one to %2.</source>
        <translation>%1 Bilder gespeichert, das letzte als %2.</translation>
    </message>
    <message>
        <source>%1 screenshots saved, the last one to %2.</source>
        <translation>%1 Bildschirmfotos gespeichert, das letzte als %2.</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>%1 steps, %2 ms</source>
        <translation>%1 Schritte, %2 ms</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 views from %2</source>
        <translation>%1 Ansichten von %2</translation>
    </message>
    <message>
        <source>%1 views of %2, small ones to look at</source>
        <translation>%1 Ansichten von %2, kleine zum Anschauen</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was loaded and was not overwritten. Save under another name, or load it again.</source>
        <translation>%1 wurde seit dem Laden von einem anderen Programm geändert und nicht überschrieben. Speichern Sie unter einem anderen Namen, oder laden Sie es erneut.</translation>
    </message>
    <message>
        <source>%1 was loaded, with changes:</source>
        <translation>%1 wurde geladen, mit Änderungen:</translation>
    </message>
    <message>
        <source>%1 was not measured.</source>
        <translation>%1 wurde nicht gemessen.</translation>
    </message>
    <message>
        <source>%1 was not put into the hall: every place for an object of yours is taken. Clear the file of one in the parameters of the hall, or drop this one there to replace it.</source>
        <translation>%1 wurde nicht in die Halle gestellt: Alle Plätze für Ihre Objekte sind belegt. Bitte die Datei eines Objekts in den Parametern der Halle leeren oder diese dort ablegen, um es zu ersetzen.</translation>
    </message>
    <message>
        <source>%1 was not put into the sky: a panorama of the whole sky is twice as wide as high, and this picture has %2 × %3 pixels. To stretch it over the sky all the same, choose it as “Environment” in the parameters of the hall.</source>
        <translation>%1 wurde nicht an den Himmel gesetzt: Ein Panorama des ganzen Himmels ist doppelt so breit wie hoch, und dieses Bild hat %2 × %3 Pixel. Um es dennoch über den Himmel zu spannen, wählen Sie es in den Parametern der Halle als „Umgebung“.</translation>
    </message>
    <message>
        <source>%1 was not saved: its name must end in .csv, .json, .png or .svg.</source>
        <translation>%1 wurde nicht gespeichert: Der Name muss auf .csv, .json, .png oder .svg enden.</translation>
    </message>
    <message>
        <source>%1 was opened, with changes: %2</source>
        <translation>%1 wurde geöffnet, mit Änderungen: %2</translation>
    </message>
    <message>
        <source>%1 was saved by another program, and you have changes that are not in it.</source>
        <translation>%1 wurde von einem anderen Programm gespeichert, und Sie haben Änderungen, die nicht darin sind.</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 × %2 dots, seen around the one at %3, %4.</source>
        <translation>%1 × %2 Punkte, gesehen um den bei %3, %4.</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, clock: %3</source>
        <translation>%1 × %2 Pixel, Uhr: %3</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>%1 — Vitrine</source>
        <translation>%1 — Vitrine</translation>
    </message>
    <message>
        <source>%1, %2 bit</source>
        <translation>%1, %2 Bit</translation>
    </message>
    <message>
        <source>%1, %2, from %3</source>
        <translation>%1, %2, aus %3</translation>
    </message>
    <message>
        <source>%1, azimuth</source>
        <translation>%1, Azimut</translation>
    </message>
    <message>
        <source>%1, choose a color</source>
        <translation>%1, Farbe wählen</translation>
    </message>
    <message>
        <source>%1, choose a file</source>
        <translation>%1, Datei wählen</translation>
    </message>
    <message>
        <source>%1, elevation</source>
        <translation>%1, Höhenwinkel</translation>
    </message>
    <message>
        <source>%1, linear light, %2 bit</source>
        <translation>%1, lineares Licht, %2 Bit</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, Regler</translation>
    </message>
    <message>
        <source>%1.
Times by: %2.</source>
        <translation>%1.
Zeiten nach: %2.</translation>
    </message>
    <message>
        <source>%1. Its pictures were not kept.</source>
        <translation>%1. Ihre Bilder wurden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2%3</source>
        <translation>%1: %2%3</translation>
    </message>
    <message>
        <source>%1: %2: %3 | %4</source>
        <translation>%1: %2: %3 | %4</translation>
    </message>
    <message>
        <source>%1: all parameters</source>
        <translation>%1: alle Parameter</translation>
    </message>
    <message>
        <source>%1: another metric, left out</source>
        <translation>%1: anderes Maß, weggelassen</translation>
    </message>
    <message>
        <source>%1: error %2</source>
        <translation>%1: Fehler %2</translation>
    </message>
    <message>
        <source>%1: from %2 at %3 to %4 at %5.</source>
        <translation>%1: von %2 bei %3 bis %4 bei %5.</translation>
    </message>
    <message>
        <source>%1: the current settings, a preset, or settings kept there.</source>
        <translation>%1: die jetzigen Einstellungen, ein Preset oder dort gemerkte Einstellungen.</translation>
    </message>
    <message>
        <source>%1: what does accuracy cost?</source>
        <translation>%1: Was kostet Genauigkeit?</translation>
    </message>
    <message>
        <source>%1: why does it have no effect?</source>
        <translation>%1: Warum hat das keine Wirkung?</translation>
    </message>
    <message>
        <source>%1; the references are no more accurate than that</source>
        <translation>%1; genauer sind die Referenzen nicht</translation>
    </message>
    <message numerus="yes">
        <source>%n at most</source>
        <translation>
            <numerusform>höchstens %n</numerusform>
            <numerusform>höchstens %n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n preset(s) with this tag</source>
        <translation>
            <numerusform>%n Preset mit diesem Tag</numerusform>
            <numerusform>%n Presets mit diesem Tag</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;About Vitrine</source>
        <translation>Ü&amp;ber Vitrine</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Bare picture</source>
        <translation>&amp;Nur das Bild</translation>
    </message>
    <message>
        <source>&amp;Bookmarks</source>
        <translation>Lese&amp;zeichen</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>&amp;Commands…</source>
        <translation>&amp;Befehle…</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleich</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Cost</source>
        <translation>&amp;Kosten</translation>
    </message>
    <message>
        <source>&amp;Cost:</source>
        <translation>&amp;Kosten:</translation>
    </message>
    <message>
        <source>&amp;Delete all bookmarks</source>
        <translation>Alle Lesezeichen &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Draw anew</source>
        <translation>&amp;Neu zeichnen</translation>
    </message>
    <message>
        <source>&amp;Duplicate preset</source>
        <translation>Preset &amp;duplizieren</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;End the comparison</source>
        <translation>Vergleich b&amp;eenden</translation>
    </message>
    <message>
        <source>&amp;Export preset…</source>
        <translation>Preset e&amp;xportieren…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Find a parameter</source>
        <translation>Parameter &amp;suchen</translation>
    </message>
    <message>
        <source>&amp;Flicker</source>
        <translation>Wec&amp;hselbild</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>&amp;Hold the current settings as B</source>
        <translation>Jetzige Einstellungen als B fes&amp;thalten</translation>
    </message>
    <message>
        <source>&amp;Import preset…</source>
        <translation>Preset &amp;importieren…</translation>
    </message>
    <message>
        <source>&amp;Keyboard, mouse and gamepad</source>
        <translation>&amp;Tastatur, Maus und Gamepad</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>Lektion &amp;verlassen</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Lektion</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;More like this</source>
        <translation>Mehr &amp;wie diese</translation>
    </message>
    <message>
        <source>&amp;Move panel</source>
        <translation>Bedienfeld verschi&amp;eben</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>&amp;Schmaler</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>Nächstes Be&amp;dienfeld</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>&amp;Open as B…</source>
        <translation>Als B ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Open lesson…</source>
        <translation>Lektion ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Preset</translation>
    </message>
    <message>
        <source>&amp;Press the exhibit's button</source>
        <translation>Knopf des Exponats &amp;drücken</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Reload shaders</source>
        <translation>Shader neu &amp;laden</translation>
    </message>
    <message>
        <source>&amp;Rename preset</source>
        <translation>Preset um&amp;benennen</translation>
    </message>
    <message>
        <source>&amp;Save preset</source>
        <translation>Preset &amp;speichern</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Startwert</translation>
    </message>
    <message>
        <source>&amp;Shorter</source>
        <translation>&amp;Niedriger</translation>
    </message>
    <message>
        <source>&amp;Start the exhibit's lesson</source>
        <translation>&amp;Lektion dazu starten</translation>
    </message>
    <message>
        <source>&amp;Start the lesson</source>
        <translation>Lektion &amp;starten</translation>
    </message>
    <message>
        <source>&amp;Tags of preset…</source>
        <translation>&amp;Tags des Presets…</translation>
    </message>
    <message>
        <source>&amp;Taller</source>
        <translation>&amp;Höher</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo step</source>
        <translation>&amp;Bearbeitungsschritt</translation>
    </message>
    <message>
        <source>&amp;Undo step as B…</source>
        <translation>Be&amp;arbeitungsschritt als B…</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>&amp;Breiter</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>&amp;Wischblende</translation>
    </message>
    <message>
        <source>&amp;Your objects</source>
        <translation>&amp;Ihre Objekte</translation>
    </message>
    <message>
        <source>(B − A) × %1</source>
        <translation>(B − A) × %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>, %1 %2</source>
        <translation>, %1 %2</translation>
    </message>
    <message>
        <source>, %1 ms (%2 to %3)</source>
        <translation>, %1 ms (%2 bis %3)</translation>
    </message>
    <message>
        <source>, alone {1}</source>
        <translation>, allein {1}</translation>
    </message>
    <message>
        <source>, and its</source>
        <translation>, und ihre</translation>
    </message>
    <message>
        <source>, and one print rolls in after the other</source>
        <translation>, und ein Druck rollt nach dem anderen herein</translation>
    </message>
    <message>
        <source>, and {1} more</source>
        <translation>, und {1} weitere</translation>
    </message>
    <message>
        <source>, as cheap as at present as far as can be told</source>
        <translation>, so billig wie jetzt, soweit es sich sagen lässt</translation>
    </message>
    <message>
        <source>, from aside</source>
        <translation>, von der Seite</translation>
    </message>
    <message>
        <source>, its history starts again: {1}</source>
        <translation>, der Verlauf beginnt von vorn: {1}</translation>
    </message>
    <message>
        <source>, less than a quarter of the smallest error, {1}</source>
        <translation>, weniger als ein Viertel des kleinsten Fehlers, {1}</translation>
    </message>
    <message>
        <source>, line {1}, {2}</source>
        <translation>, Zeile {1}, {2}</translation>
    </message>
    <message>
        <source>, not trusted</source>
        <translation>, nicht verlässlich</translation>
    </message>
    <message>
        <source>, or {1}</source>
        <translation>, oder {1}</translation>
    </message>
    <message>
        <source>, part {1}</source>
        <translation>, Teil {1}</translation>
    </message>
    <message>
        <source>, parts {1} to {2}</source>
        <translation>, Teile {1} bis {2}</translation>
    </message>
    <message>
        <source>, period {1} s</source>
        <translation>, Periode {1} s</translation>
    </message>
    <message>
        <source>, previous step %1</source>
        <translation>, voriger Schritt %1</translation>
    </message>
    <message>
        <source>, subject {1}</source>
        <translation>, Objekt {1}</translation>
    </message>
    <message>
        <source>, the present setting</source>
        <translation>, die jetzige Einstellung</translation>
    </message>
    <message>
        <source>, {1} ms</source>
        <translation>, {1} ms</translation>
    </message>
    <message>
        <source>, {1} times cheaper than at present</source>
        <translation>, {1}-mal billiger als jetzt</translation>
    </message>
    <message>
        <source>, {1} times the cost of the present setting</source>
        <translation>, das {1}-fache der Kosten der jetzigen Einstellung</translation>
    </message>
    <message>
        <source>--alone: the hall cannot be shown without the hall; name an exhibit.</source>
        <translation>--alone: Die Halle lässt sich nicht ohne die Halle zeigen; nennen Sie ein Exponat.</translation>
    </message>
    <message>
        <source>--animate {1}: {2}</source>
        <translation>--animate {=1}: {2}</translation>
    </message>
    <message>
        <source>--border-mm: charts have a border of their own.</source>
        <translation>--border-mm: Testtafeln haben einen eigenen Rand.</translation>
    </message>
    <message>
        <source>--channels: &quot;{1}&quot; is no channel; give color, depth, normal or evaluations, separated by commas.</source>
        <translation>--channels: &quot;{=1}&quot; ist kein Kanal; nennen Sie color, depth, normal oder evaluations, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>--channels: only OpenEXR carries more than color; give --out a name that ends in .exr.</source>
        <translation>--channels: Nur OpenEXR trägt mehr als Farbe; geben Sie --out einen Namen, der auf .exr endet.</translation>
    </message>
    <message>
        <source>--chart pitch</source>
        <translation>--chart pitch</translation>
    </message>
    <message>
        <source>--cost &quot;{1}&quot; is no cost of a chart; give ms or work.</source>
        <translation>--cost „{=1}“ sind keine Kosten eines Diagramms; geben Sie ms oder work an.</translation>
    </message>
    <message>
        <source>--cost work: these studies share no count of work; give ms.</source>
        <translation>--cost work: Diese Studien haben keine gemeinsame Zählung der Arbeit; geben Sie ms an.</translation>
    </message>
    <message>
        <source>--count {1}: there are {2} views; give 1 to {3}, or leave it out for all.</source>
        <translation>--count {=1}: Es gibt {=2} Ansichten; geben Sie 1 bis {=3} an, oder lassen Sie es für alle weg.</translation>
    </message>
    <message>
        <source>--every and --ping-pong choose among pictures; the views of an exhibit are made as many as --count says.</source>
        <translation>--every und --ping-pong wählen unter Bildern aus; von einem Exponat entstehen so viele Ansichten, wie --count sagt.</translation>
    </message>
    <message>
        <source>--every {1}: give 1 or more.</source>
        <translation>--every {=1}: Geben Sie 1 oder mehr an.</translation>
    </message>
    <message>
        <source>--high: all three numbers are above those of --low.</source>
        <translation>--high: Alle drei Zahlen liegen über denen von --low.</translation>
    </message>
    <message>
        <source>--low and --high belong together: two corners of the part that is meshed.</source>
        <translation>--low und --high gehören zusammen: zwei Ecken des Teils, der vernetzt wird.</translation>
    </message>
    <message>
        <source>--lpi is missing: give the sheet's lenses per inch, or a --sheet.</source>
        <translation>--lpi fehlt: Geben Sie die Linsen pro Zoll der Folie an, oder ein --sheet.</translation>
    </message>
    <message>
        <source>--method guard</source>
        <translation>--method guard</translation>
    </message>
    <message>
        <source>--metric {1}: both pictures need the channel for it; make them with `vitrine render ... --channels color,depth,normal --out NAME.exr`.</source>
        <translation>--metric {=1}: Beide Bilder brauchen den Kanal dafür; erzeugen Sie sie mit `vitrine render ... --channels color,depth,normal --out NAME.exr`.</translation>
    </message>
    <message>
        <source>--out is missing: say where the print goes, to a name that ends in {1}</source>
        <translation>--out fehlt: Sagen Sie, wohin der Druck geht, mit einem Namen, der auf {1} endet</translation>
    </message>
    <message>
        <source>--out {1}: give a name that ends in {2}</source>
        <translation>--out {=1}: Geben Sie einen Namen an, der auf {2} endet</translation>
    </message>
    <message>
        <source>--out {1}: this folder holds something else than {2}; name another.</source>
        <translation>--out {=1}: Dieser Ordner enthält etwas anderes als {2}; nennen Sie einen anderen.</translation>
    </message>
    <message>
        <source>--out {1}: this is a file; name a folder.</source>
        <translation>--out {=1}: Dies ist eine Datei; nennen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>--palette own</source>
        <translation>--palette own</translation>
    </message>
    <message>
        <source>--path still</source>
        <translation>--path still</translation>
    </message>
    <message>
        <source>--path tour: the tour goes through the hall; record hall, or choose turntable or still.</source>
        <translation>--path tour: Der Rundgang führt durch die Halle; nehmen Sie hall auf, oder wählen Sie turntable oder still.</translation>
    </message>
    <message>
        <source>--path turntable</source>
        <translation>--path turntable</translation>
    </message>
    <message>
        <source>--quilt &quot;{1}&quot;: give columns x rows, each from 1 to 1000, and the picture, such as --quilt 8x6 quilt.png.</source>
        <translation>--quilt „{=1}“: Geben Sie Spalten x Zeilen an, jeweils 1 bis 1000, und das Bild, etwa --quilt 8x6 quilt.png.</translation>
    </message>
    <message>
        <source>--save-views {1}: {2}.</source>
        <translation>--save-views {=1}: {2}.</translation>
    </message>
    <message>
        <source>--scale {1}: a scale of 0 leaves nothing to draw; give three numbers away from 0.</source>
        <translation>--scale {=1}: Ein Maßstab von 0 lässt nichts zu zeichnen; geben Sie drei Zahlen an, die nicht 0 sind.</translation>
    </message>
    <message>
        <source>--set {1}: &quot;{2}&quot; is no value for it{3} give {4}</source>
        <translation>--set {=1}: &quot;{=2}&quot; ist kein Wert dafür{3} geben Sie an: {4}</translation>
    </message>
    <message>
        <source>--set {1}: give name=value.</source>
        <translation>--set {=1}: Geben Sie Name=Wert an.</translation>
    </message>
    <message>
        <source>--set {1}: the scene has no such parameter and no other.</source>
        <translation>--set {=1}: Die Szene hat keinen solchen Parameter und auch keinen anderen.</translation>
    </message>
    <message>
        <source>--set {1}: the scene has no such parameter; it has {2}.</source>
        <translation>--set {=1}: Die Szene hat keinen solchen Parameter; sie hat {=2}.</translation>
    </message>
    <message>
        <source>--set {1}: {2} was brought to {3}, the nearest that is allowed ({4}).</source>
        <translation>--set {=1}: {=2} wurde auf {=3} gebracht, den nächsten erlaubten Wert ({4}).</translation>
    </message>
    <message>
        <source>--set {1}: {2} was brought to {3}, the nearest that is allowed ({4}; degrees are written {5}deg).</source>
        <translation>--set {=1}: {=2} wurde auf {=3} gebracht, den nächsten erlaubten Wert ({4}; Grad schreibt man {=5}deg).</translation>
    </message>
    <message>
        <source>--set {1}={2}: give a number from {3} to {4} {5}.</source>
        <translation>--set {=1}={=2}: Geben Sie eine Zahl von {=3} bis {=4} {=5} an.</translation>
    </message>
    <message>
        <source>--shard {1}: give the part and how many there are, from 1/1 to {2}/{3}, such as --shard 2/8.</source>
        <translation>--shard {=1}: Geben Sie den Teil und die Anzahl an, von 1/1 bis {=2}/{=3}, etwa --shard 2/8.</translation>
    </message>
    <message>
        <source>--shard {1}: only views that are rendered are made in parts; give an --exhibit and --out.</source>
        <translation>--shard {=1}: Nur gerenderte Ansichten entstehen in Teilen; geben Sie --exhibit und --out an.</translation>
    </message>
    <message>
        <source>--socket {1}: a socket's path has 1 to {2} bytes, and this one has {3}; choose a shorter one.</source>
        <translation>--socket {=1}: Der Pfad eines Sockets hat 1 bis {=2} Bytes, und dieser hat {=3}; wählen Sie einen kürzeren.</translation>
    </message>
    <message>
        <source>--socket {1}: another server answers there; stop it first, or choose another path.</source>
        <translation>--socket {=1}: Dort antwortet ein anderer Server; beenden Sie ihn zuerst, oder wählen Sie einen anderen Pfad.</translation>
    </message>
    <message>
        <source>--socket {1}: {2}</source>
        <translation>--socket {=1}: {2}</translation>
    </message>
    <message>
        <source>--sweep &quot;{1}&quot;: give name=from..to, such as --sweep morph=0..1.</source>
        <translation>--sweep &quot;{=1}&quot;: Geben Sie Name=von..bis an, etwa --sweep morph=0..1.</translation>
    </message>
    <message>
        <source>--time has no effect on a scene in which nothing moves; leave it out.</source>
        <translation>--time bewirkt nichts bei einer Szene, in der sich nichts bewegt; lassen Sie es weg.</translation>
    </message>
    <message>
        <source>--time: give a finite number of seconds.</source>
        <translation>--time: Geben Sie eine endliche Zahl von Sekunden an.</translation>
    </message>
    <message>
        <source>--values: &quot;{1}&quot; is no value for {2}; give {3}</source>
        <translation>--values: &quot;{=1}&quot; ist kein Wert für {=2}; geben Sie an: {3}</translation>
    </message>
    <message>
        <source>--values: give values separated by commas, such as --values 16,64,256.</source>
        <translation>--values: Geben Sie Werte durch Kommas getrennt an, etwa --values 16,64,256.</translation>
    </message>
    <message>
        <source>--values: name exactly one parameter before it.</source>
        <translation>--values: Nennen Sie davor genau einen Parameter.</translation>
    </message>
    <message>
        <source>--view-size {1}: a view has at most {2} pixels on a side.</source>
        <translation>--view-size {=1}: Eine Ansicht hat höchstens {=2} Pixel je Seite.</translation>
    </message>
    <message>
        <source>--with: these settings change no exhibit; say with --exhibit which one is compared.</source>
        <translation>--with: Diese Einstellungen ändern kein Exponat; nennen Sie mit --exhibit das zu vergleichende.</translation>
    </message>
    <message>
        <source>1 dot : %1 px</source>
        <translation>1 Punkt : %1 px</translation>
    </message>
    <message>
        <source>1 frame: %1 ms</source>
        <translation>1 Frame: %1 ms</translation>
    </message>
    <message>
        <source>1 parameter differs</source>
        <translation>1 Parameter verschieden</translation>
    </message>
    <message>
        <source>1 place had no outward side and was given one</source>
        <translation>1 Stelle hatte keine Außenseite und bekam eine</translation>
    </message>
    <message>
        <source>1 to 9</source>
        <translation>1 bis 9</translation>
    </message>
    <message>
        <source>1 triangle without area was left out</source>
        <translation>1 Dreieck ohne Fläche wurde weggelassen</translation>
    </message>
    <message>
        <source>10-3d</source>
        <extracomment>tables</extracomment>
        <translation>10-3d</translation>
    </message>
    <message>
        <source>10-flip</source>
        <extracomment>tables</extracomment>
        <translation>10-flip</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>100-3d</source>
        <extracomment>tables</extracomment>
        <translation>100-3d</translation>
    </message>
    <message>
        <source>100-flip</source>
        <extracomment>tables</extracomment>
        <translation>100-flip</translation>
    </message>
    <message>
        <source>15-3d</source>
        <extracomment>tables</extracomment>
        <translation>15-3d</translation>
    </message>
    <message>
        <source>15-flip</source>
        <extracomment>tables</extracomment>
        <translation>15-flip</translation>
    </message>
    <message>
        <source>16</source>
        <translation>16</translation>
    </message>
    <message>
        <source>16 bit</source>
        <extracomment>tables</extracomment>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>161-3d</source>
        <extracomment>tables</extracomment>
        <translation>161-3d</translation>
    </message>
    <message>
        <source>161-flip</source>
        <extracomment>tables</extracomment>
        <translation>161-flip</translation>
    </message>
    <message>
        <source>1920 x 1080</source>
        <extracomment>tables</extracomment>
        <translation>1920 x 1080</translation>
    </message>
    <message>
        <source>2 x 2 cells</source>
        <extracomment>tables</extracomment>
        <translation>2 x 2 Zellen</translation>
    </message>
    <message>
        <source>20-3d</source>
        <extracomment>tables</extracomment>
        <translation>20-3d</translation>
    </message>
    <message>
        <source>20-flip</source>
        <extracomment>tables</extracomment>
        <translation>20-flip</translation>
    </message>
    <message>
        <source>24 bit</source>
        <extracomment>tables</extracomment>
        <translation>24 Bit</translation>
    </message>
    <message>
        <source>240 x 135</source>
        <extracomment>tables</extracomment>
        <translation>240 x 135</translation>
    </message>
    <message>
        <source>3 tap</source>
        <extracomment>tables</extracomment>
        <translation>3 Nachbarn</translation>
    </message>
    <message>
        <source>3 x 3 cells</source>
        <extracomment>tables</extracomment>
        <translation>3 x 3 Zellen</translation>
    </message>
    <message>
        <source>30-3d</source>
        <extracomment>tables</extracomment>
        <translation>30-3d</translation>
    </message>
    <message>
        <source>30-flip</source>
        <extracomment>tables</extracomment>
        <translation>30-flip</translation>
    </message>
    <message>
        <source>32 bit</source>
        <extracomment>tables</extracomment>
        <translation>32 Bit</translation>
    </message>
    <message>
        <source>320 x 180</source>
        <extracomment>tables</extracomment>
        <translation>320 x 180</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>4 tap</source>
        <extracomment>tables</extracomment>
        <translation>4 Nachbarn</translation>
    </message>
    <message>
        <source>40-3d</source>
        <extracomment>tables</extracomment>
        <translation>40-3d</translation>
    </message>
    <message>
        <source>40-flip</source>
        <extracomment>tables</extracomment>
        <translation>40-flip</translation>
    </message>
    <message>
        <source>480 x 270</source>
        <extracomment>tables</extracomment>
        <translation>480 x 270</translation>
    </message>
    <message>
        <source>5 tap</source>
        <extracomment>tables</extracomment>
        <translation>5 Nachbarn</translation>
    </message>
    <message>
        <source>5 taps</source>
        <extracomment>tables</extracomment>
        <translation>5 Samples</translation>
    </message>
    <message>
        <source>50-3d</source>
        <extracomment>tables</extracomment>
        <translation>50-3d</translation>
    </message>
    <message>
        <source>50-flip</source>
        <extracomment>tables</extracomment>
        <translation>50-flip</translation>
    </message>
    <message>
        <source>60-3d</source>
        <extracomment>tables</extracomment>
        <translation>60-3d</translation>
    </message>
    <message>
        <source>60-flip</source>
        <extracomment>tables</extracomment>
        <translation>60-flip</translation>
    </message>
    <message>
        <source>62-3d</source>
        <extracomment>tables</extracomment>
        <translation>62-3d</translation>
    </message>
    <message>
        <source>62-flip</source>
        <extracomment>tables</extracomment>
        <translation>62-flip</translation>
    </message>
    <message>
        <source>640 x 360</source>
        <extracomment>tables</extracomment>
        <translation>640 x 360</translation>
    </message>
    <message>
        <source>75-3d</source>
        <extracomment>tables</extracomment>
        <translation>75-3d</translation>
    </message>
    <message>
        <source>75-flip</source>
        <extracomment>tables</extracomment>
        <translation>75-flip</translation>
    </message>
    <message>
        <source>75-measured</source>
        <extracomment>tables</extracomment>
        <translation>75-gemessen</translation>
    </message>
    <message>
        <source>8</source>
        <translation>8</translation>
    </message>
    <message>
        <source>9 plus tap</source>
        <extracomment>tables</extracomment>
        <translation>9 plus Nachbar</translation>
    </message>
    <message>
        <source>9 tap</source>
        <extracomment>tables</extracomment>
        <translation>9 Nachbarn</translation>
    </message>
    <message>
        <source>960 x 540</source>
        <extracomment>tables</extracomment>
        <translation>960 x 540</translation>
    </message>
    <message>
        <source>; a timer query shows {1} of the wall clock's time</source>
        <translation>; eine Timer-Abfrage zeigt das {1}-fache der Zeit der Wanduhr</translation>
    </message>
    <message>
        <source>; a timer query shows {1} of the wall clock's time, so it is not used</source>
        <translation>; eine Timer-Abfrage zeigt das {1}-fache der Zeit der Wanduhr und wird daher nicht benutzt</translation>
    </message>
    <message>
        <source>; against everything exact %1</source>
        <translation>; gegen alles exakt %1</translation>
    </message>
    <message>
        <source>; correct it there.</source>
        <translation>; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>; did you mean {1}?</source>
        <translation>; meinten Sie {=1}?</translation>
    </message>
    <message>
        <source>; skipping saves %1 ms</source>
        <translation>; Auslassen spart %1 ms</translation>
    </message>
    <message>
        <source>; slider from %1 to %2</source>
        <translation>; Regler von %1 bis %2</translation>
    </message>
    <message>
        <source>; the hall requests %1 samples, the preferences allow %2</source>
        <translation>; die Halle verlangt %1 Samples, die Einstellungen erlauben %2</translation>
    </message>
    <message>
        <source>; the sheet cannot be: {1}</source>
        <translation>; die Folie kann nicht sein: {1}</translation>
    </message>
    <message>
        <source>; when it was last drawn</source>
        <translation>; als er zuletzt gezeichnet wurde</translation>
    </message>
    <message>
        <source>&lt;b&gt;Question:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Frage:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Try:&lt;/b&gt; %1</source>
        <translation>&lt;b&gt;Aufgabe:&lt;/b&gt; %1</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>a --chart, which has views of its own</source>
        <translation>einem --chart, das eigene Ansichten hat</translation>
    </message>
    <message>
        <source>a --sheet, whose lenses are known</source>
        <translation>einer --sheet, deren Linsen bekannt sind</translation>
    </message>
    <message>
        <source>A and B are identical</source>
        <translation>A und B sind gleich</translation>
    </message>
    <message>
        <source>A bowl: the wall of a hollow sphere, open above a plane.</source>
        <translation>Eine Schale: die Wand einer hohlen Kugel, oberhalb einer Ebene offen.</translation>
    </message>
    <message>
        <source>A box around the origin.</source>
        <translation>Ein Quader um den Ursprung.</translation>
    </message>
    <message>
        <source>A box too small</source>
        <translation>Ein zu kleiner Kasten</translation>
    </message>
    <message>
        <source>A box with round edges and corners.</source>
        <translation>Ein Quader mit runden Kanten und Ecken.</translation>
    </message>
    <message>
        <source>a buffer cannot be empty.</source>
        <translation>ein Puffer kann nicht leer sein.</translation>
    </message>
    <message>
        <source>a button is in view</source>
        <translation>ein Knopf ist im Blick</translation>
    </message>
    <message>
        <source>a button was pressed</source>
        <translation>ein Knopf wurde gedrückt</translation>
    </message>
    <message>
        <source>a camera that stands still</source>
        <translation>einer Kamera, die stillsteht</translation>
    </message>
    <message>
        <source>A camera that turns by {1} degrees round {2} runs into a wall or what stands in the hall; give a smaller --turn, or --alone.</source>
        <translation>Eine Kamera, die sich um {1} Grad um {=2} dreht, stößt an eine Wand oder etwas, das in der Halle steht; geben Sie ein kleineres --turn an, oder --alone.</translation>
    </message>
    <message>
        <source>A capsule: everything within a radius of the segment from start to end.</source>
        <translation>Eine Kapsel: alles im Umkreis der Strecke von Anfang bis Ende.</translation>
    </message>
    <message>
        <source>A cell has a size above 0.</source>
        <translation>Eine Zelle ist größer als 0.</translation>
    </message>
    <message>
        <source>A chain link in the xy plane, elongated along y.</source>
        <translation>Ein Kettenglied in der xy-Ebene, entlang y gestreckt.</translation>
    </message>
    <message>
        <source>A chart needs at least 40 mm across the lenses and 44 mm along them.</source>
        <translation>Ein Testchart braucht mindestens 40 mm quer zu den Linsen und 44 mm entlang.</translation>
    </message>
    <message>
        <source>a combination needs two &quot;shapes&quot;</source>
        <translation>eine Kombination braucht zwei „shapes“</translation>
    </message>
    <message>
        <source>a condition names a row that its table does not have</source>
        <translation>eine Bedingung nennt eine Zeile, die ihre Tabelle nicht hat</translation>
    </message>
    <message>
        <source>A cone around the y axis with its base at y = 0 and its tip up.</source>
        <translation>Ein Kegel um die y-Achse, Grundfläche bei y = 0, Spitze oben.</translation>
    </message>
    <message>
        <source>A cylinder around the y axis with round edges.</source>
        <translation>Ein Zylinder um die y-Achse mit runden Kanten.</translation>
    </message>
    <message>
        <source>A cylinder around the y axis.</source>
        <translation>Ein Zylinder um die y-Achse.</translation>
    </message>
    <message>
        <source>a data: URI has a comma before its data; export the file again.</source>
        <translation>ein data:-URI hat vor seinen Daten ein Komma; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>a direction needs a number that is not 0</source>
        <translation>eine Richtung braucht eine Zahl, die nicht 0 ist</translation>
    </message>
    <message>
        <source>A disk in the xy plane, infinite along z; use it in extrude or revolve.</source>
        <translation>Eine Scheibe in der xy-Ebene, unendlich entlang z; zum Strecken (extrude) oder Drehen (revolve).</translation>
    </message>
    <message>
        <source>A field, its octaves, a sea and a sky: all of them random numbers.</source>
        <translation>Ein Feld, seine Oktaven, ein Meer und ein Himmel: alles Zufallszahlen.</translation>
    </message>
    <message>
        <source>A file cannot be animated, because each value would have to be read.</source>
        <translation>Eine Datei lässt sich nicht animieren, weil jeder Wert gelesen werden müsste.</translation>
    </message>
    <message>
        <source>a file name</source>
        <translation>ein Dateiname</translation>
    </message>
    <message>
        <source>A file of shapes becomes a shader; its numbers become sliders.</source>
        <translation>Eine Datei mit Formen wird ein Shader; ihre Zahlen werden Regler.</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>a finite number.</source>
        <translation>eine endliche Zahl.</translation>
    </message>
    <message>
        <source>A GIF counts in hundredths of a second, and programs show no more than 50 frames a second of it; give at most 50, or choose .webp or .apng.</source>
        <translation>Ein GIF zählt in hundertstel Sekunden, und Programme zeigen davon nicht mehr als 50 Frames pro Sekunde; geben Sie höchstens 50 an, oder wählen Sie .webp oder .apng.</translation>
    </message>
    <message>
        <source>A half-space: everything below a plane.</source>
        <translation>Ein Halbraum: alles unterhalb einer Ebene.</translation>
    </message>
    <message>
        <source>A hexagon in the xy plane, flat sides up and down, infinite along z; use it in extrude or revolve.</source>
        <translation>Ein Sechseck in der xy-Ebene, flache Seiten oben und unten, unendlich entlang z; zum Strecken (extrude) oder Drehen (revolve).</translation>
    </message>
    <message>
        <source>a key contains a control character; remove it</source>
        <translation>ein Schlüssel enthält ein Steuerzeichen; entfernen Sie es</translation>
    </message>
    <message>
        <source>A lake at night, and lanterns on it to the horizon: each looked for only where it can be.</source>
        <translation>Ein See bei Nacht, Laternen bis zum Horizont: jede nur dort gesucht, wo sie sein kann.</translation>
    </message>
    <message>
        <source>a lamp throws its shadow</source>
        <translation>eine Lampe wirft ihren Schatten</translation>
    </message>
    <message>
        <source>A left of the line, at %1 %; right of it %2.</source>
        <translation>Links der Linie A, bei %1 %; rechts davon %2.</translation>
    </message>
    <message>
        <source>a lesson begins with its title; write &quot;# Title&quot;.</source>
        <translation>eine Lektion beginnt mit ihrem Titel; schreiben Sie „# Titel“.</translation>
    </message>
    <message>
        <source>a lesson has at most {1} steps; make two of it.</source>
        <translation>eine Lektion hat höchstens {1} Schritte; machen Sie zwei daraus.</translation>
    </message>
    <message>
        <source>a lesson has one title; write &quot;## &quot; for a step.</source>
        <translation>eine Lektion hat einen Titel; schreiben Sie „## “ für einen Schritt.</translation>
    </message>
    <message>
        <source>A line for a terminal is on the clipboard.</source>
        <translation>Eine Zeile für ein Terminal liegt in der Zwischenablage.</translation>
    </message>
    <message>
        <source>A line for a terminal, which writes the same files.</source>
        <translation>Eine Zeile für ein Terminal, die dieselben Dateien schreibt.</translation>
    </message>
    <message>
        <source>a mesh is shown instead of the field</source>
        <translation>anstelle des Felds wird ein Netz gezeigt</translation>
    </message>
    <message>
        <source>A mesh with cells of {1} m would take about {2} GB of memory, more than {3} GB; give --cell {4}m or more, or a smaller part.</source>
        <translation>Ein Netz mit Zellen von {=1} m bräuchte etwa {=2} GB Speicher, mehr als {=3} GB; geben Sie --cell {=4}m oder mehr an, oder einen kleineren Teil.</translation>
    </message>
    <message>
        <source>a name that ends in &quot;{1}&quot; does not fit the format {2}</source>
        <translation>ein Name, der auf „{=1}“ endet, passt nicht zum Format {2}</translation>
    </message>
    <message>
        <source>a newer Vitrine wrote this (version {1}; this one reads version {2}); open it with that one.</source>
        <translation>ein neueres Vitrine hat dies geschrieben (Version {1}; dieses liest Version {2}); öffnen Sie es damit.</translation>
    </message>
    <message>
        <source>A node cannot be moved into itself.</source>
        <translation>Ein Knoten kann nicht in sich selbst verschoben werden.</translation>
    </message>
    <message>
        <source>a node must be an object: { &quot;kind&quot;: &quot;sphere&quot; }</source>
        <translation>ein Knoten muss ein Objekt sein: { &quot;kind&quot;: &quot;sphere&quot; }</translation>
    </message>
    <message>
        <source>a number from {1} to {2}</source>
        <translation>eine Zahl von {=1} bis {=2}</translation>
    </message>
    <message>
        <source>a number in degrees, or an expression such as &quot;90 * t&quot;</source>
        <translation>eine Zahl in Grad, oder ein Ausdruck wie „90 * t“</translation>
    </message>
    <message>
        <source>a number in meters, or an expression such as &quot;12 mm&quot; or &quot;0.5 + 0.1 * sin(t)&quot;</source>
        <translation>eine Zahl in Metern, oder ein Ausdruck wie „12 mm“ oder „0.5 + 0.1 * sin(t)“</translation>
    </message>
    <message>
        <source>a number, or an expression such as &quot;0.5 + 0.1 * sin(t)&quot;</source>
        <translation>eine Zahl, oder ein Ausdruck wie „0.5 + 0.1 * sin(t)“</translation>
    </message>
    <message>
        <source>A on the left; on the right %1.</source>
        <translation>Links A; rechts %1.</translation>
    </message>
    <message>
        <source>a panorama replaces the night sky</source>
        <translation>ein Panorama ersetzt den Nachthimmel</translation>
    </message>
    <message>
        <source>a parameter cannot depend on others; give a number</source>
        <translation>ein Parameter kann nicht von anderen abhängen; geben Sie eine Zahl an</translation>
    </message>
    <message>
        <source>a parameter's name has letters and digits, a letter first</source>
        <translation>der Name eines Parameters hat Buchstaben und Ziffern, zuerst einen Buchstaben</translation>
    </message>
    <message>
        <source>a picture has either a uri or a bufferView; export the file again.</source>
        <translation>ein Bild hat entweder ein uri oder eine bufferView; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>a picture has other channels</source>
        <translation>ein Bild hat andere Kanäle</translation>
    </message>
    <message>
        <source>A picture needs at least 1 × 1 pixels; {1} × {2} were asked for.</source>
        <translation>Ein Bild braucht mindestens 1 × 1 Pixel; verlangt wurden {1} × {2}.</translation>
    </message>
    <message>
        <source>A picture of </source>
        <translation>Ein Bild von </translation>
    </message>
    <message>
        <source>A picture of {1} uses the second texture coordinates; the first are used.</source>
        <translation>Ein Bild von {1} benutzt die zweiten Texturkoordinaten; benutzt werden die ersten.</translation>
    </message>
    <message>
        <source>a picture without the channel depth.Z</source>
        <translation>ein Bild ohne den Kanal depth.Z</translation>
    </message>
    <message>
        <source>A pitch one percent off</source>
        <translation>Teilung um ein Prozent falsch</translation>
    </message>
    <message>
        <source>a plaque is in view</source>
        <translation>ein Schild ist im Blick</translation>
    </message>
    <message>
        <source>a PNG, which is always compressed</source>
        <translation>einem PNG, das immer gepackt ist</translation>
    </message>
    <message>
        <source>A point light that shines in all directions.</source>
        <translation>Ein Punktlicht, das in alle Richtungen scheint.</translation>
    </message>
    <message>
        <source>A preset &quot;%1&quot; already exists; this one was saved as &quot;%2&quot;.</source>
        <translation>Ein Preset „%1“ gibt es bereits; dieses wurde als „%2“ gespeichert.</translation>
    </message>
    <message>
        <source>A preset has at most {1} tags; these are {2}</source>
        <translation>Ein Preset hat höchstens {1} Tags; es sind {2}</translation>
    </message>
    <message>
        <source>A preset, a picture with one inside, a scene of shapes, a model or a panorama.</source>
        <translation>Ein Preset, ein Bild mit eingebettetem Preset, eine Formenszene, ein Modell oder ein Panorama.</translation>
    </message>
    <message>
        <source>A print of {1} x {2} pixels is too large to be held at once; choose one of up to 67 million pixels.</source>
        <translation>Ein Druck von {1} x {2} Pixeln ist zu groß, um ihn auf einmal zu halten; wählen Sie einen mit bis zu 67 Millionen Pixeln.</translation>
    </message>
    <message>
        <source>A prism along y with a rhombus in the xz plane.</source>
        <translation>Ein Prisma entlang y mit einer Raute in der xz-Ebene.</translation>
    </message>
    <message>
        <source>A prism along z with a regular hexagon in the xy plane, flat sides up and down.</source>
        <translation>Ein Prisma entlang z mit einem regelmäßigen Sechseck in der xy-Ebene, flache Seiten oben und unten.</translation>
    </message>
    <message>
        <source>A prism along z with an equilateral triangle in the xy plane, a corner up.</source>
        <translation>Ein Prisma entlang z mit einem gleichseitigen Dreieck in der xy-Ebene, eine Ecke oben.</translation>
    </message>
    <message>
        <source>A pyramid with a square base at y = 0.</source>
        <translation>Eine Pyramide mit quadratischer Grundfläche bei y = 0.</translation>
    </message>
    <message>
        <source>A quarter of a pixel is wider, and is used instead.</source>
        <translation>Ein Viertel eines Pixels ist breiter und gilt stattdessen.</translation>
    </message>
    <message>
        <source>A quilt of {1} x {2} pixels does not hold {3} x {4} views; give fewer columns and rows.</source>
        <translation>Ein Quilt von {1} x {2} Pixeln fasst keine {3} x {4} Ansichten; geben Sie weniger Spalten und Zeilen an.</translation>
    </message>
    <message>
        <source>a range is two numbers, the lower one first: [0, 1]</source>
        <translation>ein Bereich sind zwei Zahlen, die kleinere zuerst: [0, 1]</translation>
    </message>
    <message>
        <source>A rectangle in the xy plane, infinite along z; use it in extrude or revolve.</source>
        <translation>Ein Rechteck in der xy-Ebene, unendlich entlang z; zum Strecken (extrude) oder Drehen (revolve).</translation>
    </message>
    <message>
        <source>A rectangular light that shines to one side.</source>
        <translation>Ein rechteckiges Licht, das zu einer Seite scheint.</translation>
    </message>
    <message>
        <source>A regular octahedron with its corners on the axes.</source>
        <translation>Ein regelmäßiges Oktaeder mit den Ecken auf den Achsen.</translation>
    </message>
    <message>
        <source>a scene in which nothing moves</source>
        <translation>einer Szene, in der sich nichts bewegt</translation>
    </message>
    <message>
        <source>A scene of more than 1 MB is not edited here; change its file.</source>
        <translation>Eine Szene von mehr als 1 MB wird hier nicht bearbeitet; ändern Sie ihre Datei.</translation>
    </message>
    <message>
        <source>a scene of the reference</source>
        <translation>eine Szene der Referenz</translation>
    </message>
    <message>
        <source>a scene of the reference needs a &quot;camera&quot;</source>
        <translation>eine Szene der Referenz braucht eine „camera“</translation>
    </message>
    <message>
        <source>A shader failed to compile; the last good picture is kept. Save the file to try again.</source>
        <translation>Ein Shader ließ sich nicht übersetzen; das letzte gute Bild bleibt. Wird die Datei gespeichert, folgt der nächste Versuch.</translation>
    </message>
    <message>
        <source>A shape between the first child and the second.</source>
        <translation>Eine Form zwischen dem ersten und dem zweiten Kind.</translation>
    </message>
    <message>
        <source>A shape cannot become an operation; wrap it in a {1} instead.</source>
        <translation>Eine Form kann keine Operation werden; packen Sie sie in „{1}“ ein.</translation>
    </message>
    <message>
        <source>A shape holds no other node; delete the operation, or take it away from around its child.</source>
        <translation>Eine Form enthält keinen anderen Knoten; löschen Sie die Operation, oder nehmen Sie sie um ihr Kind herum weg.</translation>
    </message>
    <message>
        <source>A sheet needs a name to be saved under.</source>
        <translation>Eine Folie braucht einen Namen, um gespeichert zu werden.</translation>
    </message>
    <message>
        <source>A sheet to print and lay the lenses on: pitch, phase, number of views, rotation.</source>
        <translation>Ein Blatt zum Drucken und Auflegen der Linsen: Linsenabstand, Phase, Zahl der Ansichten, Drehung.</translation>
    </message>
    <message>
        <source>A shell around the child's surface, hollow inside.</source>
        <translation>Eine Wand um die Oberfläche des Kindes, innen hohl.</translation>
    </message>
    <message>
        <source>A shortcut has only one key combination.</source>
        <translation>Ein Tastenkürzel hat nur eine Tastenkombination.</translation>
    </message>
    <message>
        <source>A solid sphere around the origin.</source>
        <translation>Eine Kugel um den Ursprung.</translation>
    </message>
    <message>
        <source>A sphere cut off above a plane.</source>
        <translation>Eine Kugel, oberhalb einer Ebene abgeschnitten.</translation>
    </message>
    <message>
        <source>A sphere sector: the part of a sphere within a cone around +y.</source>
        <translation>Ein Kugelsektor: der Teil einer Kugel in einem Kegel um +y.</translation>
    </message>
    <message>
        <source>A sphere with a spherical dent, cut by another sphere above it.</source>
        <translation>Eine Kugel mit einer kugelförmigen Delle, geschnitten von einer anderen Kugel darüber.</translation>
    </message>
    <message>
        <source>A spindle with sharp tips at start and end.</source>
        <translation>Eine Spindel mit scharfen Spitzen an Anfang und Ende.</translation>
    </message>
    <message>
        <source>A sprite sheet takes at least one frame.</source>
        <translation>Ein Blatt mit Sprites nimmt mindestens einen Frame auf.</translation>
    </message>
    <message>
        <source>a stride is a multiple of 4 from 4 to 252; export the file again.</source>
        <translation>eine Schrittweite ist ein Vielfaches von 4 zwischen 4 und 252; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>a stride must be 4 to 252</source>
        <translation>eine Schrittweite muss zwischen 4 und 252 liegen</translation>
    </message>
    <message>
        <source>A study goes by an error that falls to 0: study rmse, of which psnr is the decibels.</source>
        <translation>Eine Studie richtet sich nach einem Fehler, der auf 0 fällt: Untersuchen Sie rmse, dessen Dezibel psnr ist.</translation>
    </message>
    <message>
        <source>A study needs a parameter that is marked as quality; `vitrine list --json` names them.</source>
        <translation>Eine Studie braucht einen Parameter, der als Qualität gekennzeichnet ist; `vitrine list --json` nennt sie.</translation>
    </message>
    <message>
        <source>a study of --values</source>
        <translation>einer Studie mit --values</translation>
    </message>
    <message>
        <source>a study of one or two parameters</source>
        <translation>einer Studie von einem oder zwei Parametern</translation>
    </message>
    <message>
        <source>A study over three parameters or more searches: which settings it measures depends on those before, so it cannot be split; study one or two parameters.</source>
        <translation>Eine Studie über drei Parameter oder mehr sucht: Welche Einstellungen sie misst, hängt von denen davor ab, daher lässt sie sich nicht teilen; untersuchen Sie einen oder zwei Parameter.</translation>
    </message>
    <message>
        <source>a tag has at least one character</source>
        <translation>ein Tag hat mindestens ein Zeichen</translation>
    </message>
    <message>
        <source>a tag has at most {1} bytes</source>
        <translation>ein Tag hat höchstens {1} Bytes</translation>
    </message>
    <message>
        <source>a tag has neither commas nor control characters</source>
        <translation>ein Tag enthält weder Kommas noch Steuerzeichen</translation>
    </message>
    <message>
        <source>a tag neither begins nor ends with a blank</source>
        <translation>ein Tag beginnt und endet nicht mit einem Leerzeichen</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a text here has one line that is not empty; correct it there.</source>
        <translation>ein Text hier hat eine Zeile, die nicht leer ist; berichtigen Sie ihn dort.</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>A texture of {1} has no picture of a known kind and is left out.</source>
        <translation>Eine Textur von {1} hat kein Bild bekannter Art und wird weggelassen.</translation>
    </message>
    <message>
        <source>A texture of {1} wraps differently along u and v; both wrap as u does.</source>
        <translation>Eine Textur von {1} wiederholt sich entlang u anders als entlang v; beides geschieht wie bei u.</translation>
    </message>
    <message>
        <source>A thin sheet with four corners, in order around it.</source>
        <translation>Ein dünnes Blatt mit vier Ecken, der Reihe nach ringsum.</translation>
    </message>
    <message>
        <source>A thin sheet with three corners.</source>
        <translation>Ein dünnes Blatt mit drei Ecken.</translation>
    </message>
    <message>
        <source>A to the left of a line, B to the right; drag the line. If there is no B yet, the current settings become B.</source>
        <translation>Links einer Linie A, rechts davon B; die Linie lässt sich ziehen. Gibt es noch kein B, werden die jetzigen Einstellungen zu B.</translation>
    </message>
    <message>
        <source>A torus (ring) around the y axis.</source>
        <translation>Ein Torus (Ring) um die y-Achse.</translation>
    </message>
    <message>
        <source>a tour is a JSON object; choose a tour of Vitrine.</source>
        <translation>ein Rundgang ist ein JSON-Objekt; wählen Sie einen Rundgang von Vitrine.</translation>
    </message>
    <message>
        <source>a tour's file, which says how the camera moves</source>
        <translation>der Datei eines Rundgangs, die sagt, wie sich die Kamera bewegt</translation>
    </message>
    <message>
        <source>a transparent background is requested</source>
        <translation>ein transparenter Hintergrund ist verlangt</translation>
    </message>
    <message>
        <source>A triangle in the xy plane with a corner up, infinite along z; use it in extrude or revolve.</source>
        <translation>Ein Dreieck in der xy-Ebene, eine Ecke oben, unendlich entlang z; zum Strecken (extrude) oder Drehen (revolve).</translation>
    </message>
    <message>
        <source>A truncated cone around the y axis.</source>
        <translation>Ein Kegelstumpf um die y-Achse.</translation>
    </message>
    <message>
        <source>A truncated cone from start to end.</source>
        <translation>Ein Kegelstumpf von Anfang bis Ende.</translation>
    </message>
    <message>
        <source>A up to %1 %</source>
        <translation>A bis %1 %</translation>
    </message>
    <message>
        <source>a value changed</source>
        <translation>ein Wert hat sich geändert</translation>
    </message>
    <message>
        <source>A video has 0.1 to 240 frames a second; give another number.</source>
        <translation>Ein Video hat 0.1 bis 240 Frames pro Sekunde; geben Sie eine andere Zahl an.</translation>
    </message>
    <message>
        <source>A video has sides of 1 to 16383 pixels, and not {1}; give another size.</source>
        <translation>Ein Video hat Seiten von 1 bis 16383 Pixeln, und nicht {=1}; geben Sie eine andere Größe an.</translation>
    </message>
    <message>
        <source>a view cannot be empty.</source>
        <translation>eine View kann nicht leer sein.</translation>
    </message>
    <message>
        <source>A view is empty; choose another picture.</source>
        <translation>Eine Ansicht ist leer; wählen Sie ein anderes Bild.</translation>
    </message>
    <message>
        <source>a viewing zone of {1} degrees; a lens focused on its back reaches {2} degrees with this index</source>
        <translation>eine Betrachtungszone von {1} Grad; eine auf ihre Rückseite fokussierte Linse erreicht mit diesem Index {2} Grad</translation>
    </message>
    <message>
        <source>a visitor's model</source>
        <translation>ein Modell des Besuchers</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a whole number from 0 to 2147483647</source>
        <translation>eine ganze Zahl von 0 bis 2147483647</translation>
    </message>
    <message>
        <source>a whole number from 0 up</source>
        <translation>eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>a whole number from {1} to {2}</source>
        <translation>eine ganze Zahl von {=1} bis {=2}</translation>
    </message>
    <message>
        <source>a whole number.</source>
        <translation>eine ganze Zahl.</translation>
    </message>
    <message>
        <source>A, ms</source>
        <translation>A, ms</translation>
    </message>
    <message>
        <source>A, with B kept ready: hold the key B in the picture to see it.</source>
        <translation>A, und B steht bereit: Halten Sie im Bild die Taste B, um es zu sehen.</translation>
    </message>
    <message>
        <source>A: %1 · %2</source>
        <translation>A: %1 · %2</translation>
    </message>
    <message>
        <source>A; hold the key B to see B</source>
        <translation>A; halten Sie die Taste B, um B zu sehen</translation>
    </message>
    <message>
        <source>Abbe number</source>
        <extracomment>tables</extracomment>
        <translation>Abbe-Zahl</translation>
    </message>
    <message>
        <source>Abbe number of the plastic: low spreads colors widely, high hardly. Acrylic has 57, polycarbonate 30.</source>
        <extracomment>tables</extracomment>
        <translation>Abbe-Zahl des Kunststoffs: Niedrige Werte fächern Farben weit auf, hohe kaum. Acryl hat 57, Polycarbonat 30.</translation>
    </message>
    <message>
        <source>About %1 min left</source>
        <translation>Noch etwa %1 min</translation>
    </message>
    <message>
        <source>About %1 s left</source>
        <translation>Noch etwa %1 s</translation>
    </message>
    <message>
        <source>About the shortcut</source>
        <translation>Über das Tastenkürzel</translation>
    </message>
    <message>
        <source>About this e&amp;xhibit</source>
        <translation>Über dieses &amp;Exponat</translation>
    </message>
    <message>
        <source>About this exhibit</source>
        <translation>Über dieses Exponat</translation>
    </message>
    <message>
        <source>About Vitrine</source>
        <translation>Über Vitrine</translation>
    </message>
    <message>
        <source>above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>Above the clouds</source>
        <translation>Über den Wolken</translation>
    </message>
    <message>
        <source>Absorption of sunlight on its way into the coat: 0 casts no shadow on the fur, high darkens it quickly.</source>
        <extracomment>tables</extracomment>
        <translation>Absorption des Sonnenlichts auf dem Weg ins Fell: 0 wirft keinen Schatten im Fell, hohe Werte verdunkeln es schnell.</translation>
    </message>
    <message>
        <source>Accept; restore the previous value</source>
        <translation>Übernehmen; den vorigen Wert wiederherstellen</translation>
    </message>
    <message>
        <source>accessors without data have more than {1} elements; give them a bufferView.</source>
        <translation>Accessoren ohne Daten haben mehr als {1} Elemente; geben Sie ihnen eine bufferView.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <extracomment>tables</extracomment>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>adaptive</source>
        <extracomment>tables</extracomment>
        <translation>adaptiv</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>adding a frame</source>
        <translation>das Anfügen eines Frames</translation>
    </message>
    <message>
        <source>Adds a shape or an operation to the selected one, or beside it.</source>
        <translation>Fügt der gewählten eine Form oder Operation hinzu, oder stellt sie daneben.</translation>
    </message>
    <message>
        <source>After “%1”</source>
        <translation>Nach „%1“</translation>
    </message>
    <message>
        <source>Afterglow</source>
        <extracomment>tables</extracomment>
        <translation>Nachglühen</translation>
    </message>
    <message>
        <source>against everything exact</source>
        <translation>gegen alles exakt</translation>
    </message>
    <message>
        <source>against these parameters exact</source>
        <translation>gegen diese Parameter exakt</translation>
    </message>
    <message>
        <source>against this parameter exact</source>
        <translation>gegen diesen Parameter exakt</translation>
    </message>
    <message>
        <source>Air</source>
        <extracomment>tables</extracomment>
        <translation>Luft</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Air color</source>
        <extracomment>tables</extracomment>
        <translation>Luftfarbe</translation>
    </message>
    <message>
        <source>Air density</source>
        <extracomment>tables</extracomment>
        <translation>Luftdichte</translation>
    </message>
    <message>
        <source>Air drag</source>
        <extracomment>tables</extracomment>
        <translation>Luftwiderstand</translation>
    </message>
    <message>
        <source>Albedo</source>
        <extracomment>tables</extracomment>
        <translation>Albedo</translation>
    </message>
    <message>
        <source>Albedo (diffuse color) of the solid field.</source>
        <extracomment>tables</extracomment>
        <translation>Albedo (diffuse Farbe) des festen Felds.</translation>
    </message>
    <message>
        <source>all</source>
        <extracomment>tables</extracomment>
        <translation>alle</translation>
    </message>
    <message numerus="yes">
        <source>all %n together</source>
        <translation>
            <numerusform>%n zusammen</numerusform>
            <numerusform>alle %n zusammen</numerusform>
        </translation>
    </message>
    <message>
        <source>All colors are shown in its place.</source>
        <translation>An ihrer Stelle werden alle Farben gezeigt.</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All frames of each direction are equal: the object has no animation, or none that these frames show. One frame per direction is enough.</source>
        <translation>Alle Bilder jeder Richtung sind gleich: Das Objekt hat keine Animation, oder keine, die diese Bilder zeigen. Ein Bild je Richtung genügt.</translation>
    </message>
    <message>
        <source>All its parameters are excluded from randomizing.</source>
        <translation>Alle ihre Parameter sind vom zufälligen Ändern ausgenommen.</translation>
    </message>
    <message>
        <source>all parameters</source>
        <translation>alle Parameter</translation>
    </message>
    <message>
        <source>All parameters have their initial values.</source>
        <translation>Alle Parameter haben ihre Ausgangswerte.</translation>
    </message>
    <message>
        <source>All parameters together</source>
        <translation>Alle Parameter zusammen</translation>
    </message>
    <message>
        <source>All pictures in a folder, by name; numbers count by value.</source>
        <translation>Alle Bilder eines Ordners, nach Namen; Zahlen zählen nach ihrem Wert.</translation>
    </message>
    <message>
        <source>All shortcuts on one page.</source>
        <translation>Alle Tastenkürzel auf einer Seite.</translation>
    </message>
    <message>
        <source>All that can be opened (%1)</source>
        <translation>Alles, was sich öffnen lässt (%1)</translation>
    </message>
    <message>
        <source>Along the bookmarks</source>
        <translation>Entlang der Lesezeichen</translation>
    </message>
    <message>
        <source>along the floor</source>
        <translation>den Boden entlang</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>Entlang x</translation>
    </message>
    <message>
        <source>Along z</source>
        <translation>Entlang z</translation>
    </message>
    <message>
        <source>alpha</source>
        <extracomment>tables</extracomment>
        <translation>Alpha</translation>
    </message>
    <message>
        <source>Altitude</source>
        <extracomment>tables</extracomment>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Ambient</source>
        <extracomment>tables</extracomment>
        <translation>Umgebungslicht</translation>
    </message>
    <message>
        <source>Ambient light, as linear values; only with Phong shading.</source>
        <translation>Umgebungslicht, in linearen Werten; nur bei Phong-Beleuchtung.</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <extracomment>tables</extracomment>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>ambient occlusion is switched off</source>
        <translation>Umgebungsverdeckung ist ausgeschaltet</translation>
    </message>
    <message>
        <source>Amount by which fine noise erodes the edges of the clouds: 0 is smooth, 1 is ragged.</source>
        <extracomment>tables</extracomment>
        <translation>Wie stark feines Rauschen die Ränder der Wolken abträgt: 0 ist glatt, 1 ist zerfranst.</translation>
    </message>
    <message>
        <source>Amount by which the ball's radius grows and shrinks; 0 keeps its size.</source>
        <extracomment>tables</extracomment>
        <translation>Betrag, um den der Radius des Balls wächst und schrumpft; 0 lässt die Größe gleich.</translation>
    </message>
    <message>
        <source>Amount by which the fur lags behind when the body starts, stops or spins: 0 follows at once.</source>
        <extracomment>tables</extracomment>
        <translation>Wie weit das Fell nachhängt, wenn der Körper anfährt, anhält oder sich dreht: 0 folgt sofort.</translation>
    </message>
    <message>
        <source>Amount by which the variations differ from the current settings: 100 % uses the full range of the sliders.</source>
        <translation>Wie weit die Variationen von den jetzigen Einstellungen abweichen: 100 % nutzt den ganzen Bereich der Regler.</translation>
    </message>
    <message>
        <source>Amount by which the view follows a visitor who steps aside: 0 is a flat picture, 1 a window.</source>
        <extracomment>tables</extracomment>
        <translation>Wie weit die Ansicht einem Besucher folgt, der zur Seite geht: 0 ist ein flaches Bild, 1 ein Fenster.</translation>
    </message>
    <message>
        <source>Amount of foam on the crests: 0 is none, high foams early.</source>
        <extracomment>tables</extracomment>
        <translation>Menge des Schaums auf den Kämmen: 0 ist keiner, hohe Werte schäumen früh.</translation>
    </message>
    <message>
        <source>Amount of light that comes through the fringe from behind: 0 is none, high gives a bright rim.</source>
        <extracomment>tables</extracomment>
        <translation>Menge des Lichts, das von hinten durch den Saum dringt: 0 ist keines, hohe Werte geben einen hellen Rand.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Amplitude of the first octave: 0 displaces nothing.</source>
        <translation>Amplitude der ersten Oktave: 0 verschiebt nichts.</translation>
    </message>
    <message>
        <source>An accuracy parameter cannot be animated, because it sets the cost of the picture.</source>
        <translation>Ein Genauigkeitsparameter lässt sich nicht animieren, weil er die Kosten des Bildes bestimmt.</translation>
    </message>
    <message>
        <source>An arc of a torus in the xy plane, centered at +y, with round ends.</source>
        <translation>Ein Bogen eines Torus in der xy-Ebene, um +y, mit runden Enden.</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>ein Array</translation>
    </message>
    <message>
        <source>an array of texts</source>
        <translation>eine Liste von Texten</translation>
    </message>
    <message>
        <source>an array of three numbers</source>
        <translation>ein Array von drei Zahlen</translation>
    </message>
    <message>
        <source>an array of two numbers</source>
        <translation>ein Array von zwei Zahlen</translation>
    </message>
    <message>
        <source>an array: [ ... ]</source>
        <translation>ein Array: [ ... ]</translation>
    </message>
    <message>
        <source>An ellipsoid around the origin.</source>
        <translation>Ein Ellipsoid um den Ursprung.</translation>
    </message>
    <message>
        <source>an environment</source>
        <translation>eine Umgebung</translation>
    </message>
    <message>
        <source>an exhibit stands in the sun</source>
        <translation>ein Exponat steht in der Sonne</translation>
    </message>
    <message>
        <source>an exhibit that is named as A</source>
        <translation>einem Exponat, das als A genannt ist</translation>
    </message>
    <message>
        <source>an exhibit that is shown --alone</source>
        <translation>einem Exponat, das mit --alone gezeigt wird</translation>
    </message>
    <message>
        <source>An infinite cone with its tip at the origin, opening downward.</source>
        <translation>Ein unendlicher Kegel mit der Spitze im Ursprung, nach unten geöffnet.</translation>
    </message>
    <message>
        <source>An infinite cylinder around the y axis.</source>
        <translation>Ein unendlicher Zylinder um die y-Achse.</translation>
    </message>
    <message>
        <source>An internal error was caught. The command was not executed; everything else continues.</source>
        <translation>Ein interner Fehler wurde abgefangen. Der Befehl wurde nicht ausgeführt; alles andere läuft weiter.</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an object of the visitor's stands here</source>
        <translation>ein Objekt des Besuchers steht hier</translation>
    </message>
    <message>
        <source>an object stands on the free plinth</source>
        <translation>ein Objekt steht auf dem freien Sockel</translation>
    </message>
    <message>
        <source>an object: { ... }</source>
        <translation>ein Objekt: { ... }</translation>
    </message>
    <message>
        <source>anaglyph</source>
        <extracomment>tables</extracomment>
        <translation>Anaglyphe</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiterer</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle around the sun within which the sky gives rays: 180° uses the whole sky.</source>
        <extracomment>tables</extracomment>
        <translation>Winkel um die Sonne, in dem der Himmel Strahlen gibt: 180° nutzt den ganzen Himmel.</translation>
    </message>
    <message>
        <source>Angle between the axis and the side of the cone.</source>
        <translation>Winkel zwischen der Achse und der Seite des Kegels.</translation>
    </message>
    <message>
        <source>Angle between the axis and the side.</source>
        <translation>Winkel zwischen der Achse und der Seite.</translation>
    </message>
    <message>
        <source>Angle by which a surface must turn to make an edge: low draws more lines.</source>
        <extracomment>tables</extracomment>
        <translation>Winkel, um den sich eine Oberfläche wenden muss, damit eine Kante entsteht: Niedrige Werte zeichnen mehr Linien.</translation>
    </message>
    <message>
        <source>Angle by which dragging turns the view, or orbits an exhibit.</source>
        <translation>Winkel, um den Ziehen den Blick dreht oder um ein Exponat führt.</translation>
    </message>
    <message>
        <source>Angle by which the lattice of each octave is rotated against the one before; 0 shows the lattice.</source>
        <extracomment>tables</extracomment>
        <translation>Winkel, um den das Gitter jeder Oktave gegen das vorige gedreht wird; 0 lässt das Gitter sehen.</translation>
    </message>
    <message>
        <source>Angle from +y to each end of the arc.</source>
        <translation>Winkel von +y zu jedem Ende des Bogens.</translation>
    </message>
    <message>
        <source>Angle in which all views are seen once: about 30° for depth, 50° for flips.</source>
        <translation>Winkel, in dem alle Ansichten einmal zu sehen sind: etwa 30° für Tiefe, 50° für Wechselbilder.</translation>
    </message>
    <message>
        <source>Angle in which all views are seen once; beyond it they start again.</source>
        <translation>Winkel, in dem alle Ansichten einmal zu sehen sind; darüber hinaus beginnen sie von vorn.</translation>
    </message>
    <message>
        <source>Angle of a step by which the camera turns: large keeps pixels stable for longer.</source>
        <extracomment>tables</extracomment>
        <translation>Winkel eines Schritts, um den sich die Kamera dreht: Große halten Pixel länger ruhig.</translation>
    </message>
    <message>
        <source>Angle of the bend per meter along x: 0 is straight.</source>
        <translation>Winkel der Biegung je Meter entlang x: 0 ist gerade.</translation>
    </message>
    <message>
        <source>Angle of the camera around its target.</source>
        <extracomment>tables</extracomment>
        <translation>Winkel der Kamera um ihr Ziel.</translation>
    </message>
    <message>
        <source>Angle of the eye across the lenses; positive to the right, or below for horizontal lenses.</source>
        <translation>Winkel des Auges quer zu den Linsen; positiv nach rechts, bei waagerechten Linsen nach unten.</translation>
    </message>
    <message>
        <source>Angle of the eye along the lenses; positive above, or to the right for horizontal lenses.</source>
        <translation>Winkel des Auges längs der Linsen; positiv nach oben, bei waagerechten Linsen nach rechts.</translation>
    </message>
    <message>
        <source>Angle of the twist per meter of height: 0 is straight.</source>
        <translation>Winkel der Verdrillung je Meter Höhe: 0 ist gerade.</translation>
    </message>
    <message>
        <source>Angle to either side at which the linear model reaches the outermost view.</source>
        <extracomment>tables</extracomment>
        <translation>Winkel zu jeder Seite, bei dem das lineare Modell die äußerste Ansicht erreicht.</translation>
    </message>
    <message>
        <source>angles</source>
        <extracomment>tables</extracomment>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angular diameter of the moon; the real one has half a degree.</source>
        <extracomment>tables</extracomment>
        <translation>Winkeldurchmesser des Mondes; der wirkliche misst ein halbes Grad.</translation>
    </message>
    <message>
        <source>Angular diameter of the sun for the disk filter: large softens shadows. The real sun has about half a degree.</source>
        <extracomment>tables</extracomment>
        <translation>Winkeldurchmesser der Sonne für den Scheibenfilter: Große Werte machen Schatten weich. Die wirkliche Sonne misst etwa ein halbes Grad.</translation>
    </message>
    <message>
        <source>Angular diameter of the sun.</source>
        <translation>Winkeldurchmesser der Sonne.</translation>
    </message>
    <message>
        <source>Angular diameter of the sun: wide gives soft shadows. The real sun has half a degree.</source>
        <extracomment>tables</extracomment>
        <translation>Winkeldurchmesser der Sonne: Große Werte geben weiche Schatten. Die wirkliche Sonne misst ein halbes Grad.</translation>
    </message>
    <message>
        <source>animal</source>
        <translation>Tier</translation>
    </message>
    <message>
        <source>Animate</source>
        <extracomment>tables</extracomment>
        <translation>Animieren</translation>
    </message>
    <message>
        <source>Animate %1</source>
        <translation>%1 animieren</translation>
    </message>
    <message>
        <source>Animated: %1. Setting it by hand stops the animation.</source>
        <translation>Animiert: %1. Von Hand gesetzt, endet die Animation.</translation>
    </message>
    <message>
        <source>Animate…</source>
        <translation>Animieren…</translation>
    </message>
    <message>
        <source>Animation</source>
        <extracomment>tables</extracomment>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Animation speed</source>
        <extracomment>tables</extracomment>
        <translation>Tempo der Animation</translation>
    </message>
    <message>
        <source>animation {1}</source>
        <translation>Animation {1}</translation>
    </message>
    <message>
        <source>Animations are not played in the hall; the model stands still.</source>
        <translation>Animationen werden in der Halle nicht abgespielt; das Modell steht still.</translation>
    </message>
    <message>
        <source>Animations are not supported; the model stands still.</source>
        <translation>Animationen werden nicht unterstützt; das Modell steht still.</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <extracomment>tables</extracomment>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>another kind of depth buffer is selected</source>
        <translation>eine andere Art von Tiefenpuffer ist gewählt</translation>
    </message>
    <message>
        <source>another tile is drawn</source>
        <translation>eine andere Kachel wird gezeichnet</translation>
    </message>
    <message>
        <source>another work is shown</source>
        <translation>ein anderes Werk wird gezeigt</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Answer ▸</source>
        <translation>Antwort ▸</translation>
    </message>
    <message>
        <source>Answer ▾</source>
        <translation>Antwort ▾</translation>
    </message>
    <message>
        <source>Aperture samples</source>
        <extracomment>tables</extracomment>
        <translation>Apertur-Samples</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>area</source>
        <extracomment>tables</extracomment>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Arrow keys select a variation, Enter uses it.</source>
        <translation>Pfeiltasten wählen eine Variation, Eingabe übernimmt sie.</translation>
    </message>
    <message>
        <source>Arrows go from point to point, Enter applies one.</source>
        <translation>Pfeiltasten gehen von Punkt zu Punkt, Eingabe wendet einen an.</translation>
    </message>
    <message>
        <source>as at present</source>
        <translation>wie jetzt</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>wie angegeben</translation>
    </message>
    <message>
        <source>as gravity makes them</source>
        <extracomment>tables</extracomment>
        <translation>nach der Schwerkraft</translation>
    </message>
    <message>
        <source>As in the reference</source>
        <translation>Wie in der Referenz</translation>
    </message>
    <message>
        <source>As in the reference video</source>
        <translation>Wie im Video der Referenz</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>As set in the hall</source>
        <translation>Wie in der Halle gesetzt</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>as the look has it</source>
        <extracomment>tables</extracomment>
        <translation>wie die Darstellung</translation>
    </message>
    <message>
        <source>as the scene says</source>
        <extracomment>tables</extracomment>
        <translation>wie in der Szene</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>asking every shape of so few is as fast</source>
        <translation>jede Form zu fragen, ist bei so wenigen ebenso schnell</translation>
    </message>
    <message>
        <source>Asteroids</source>
        <translation>Asteroiden</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>at rest since {1}</source>
        <translation>in Ruhe seit {1}</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Am Anfang</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>automatic</source>
        <extracomment>tables</extracomment>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Axis</source>
        <extracomment>tables</extracomment>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <extracomment>tables</extracomment>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B is: %1. Click for another B, or to copy all.</source>
        <translation>B ist: %1. Klicken Sie für ein anderes B, oder um alles zu kopieren.</translation>
    </message>
    <message>
        <source>B was not set: select a preset in the list first.</source>
        <translation>B wurde nicht gesetzt: Wählen Sie zuerst ein Preset in der Liste.</translation>
    </message>
    <message>
        <source>B, held</source>
        <translation>B, gehalten</translation>
    </message>
    <message>
        <source>B, ms</source>
        <translation>B, ms</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B: %1</translation>
    </message>
    <message>
        <source>B: %1 steps, %2 ms</source>
        <translation>B: %1 Schritte, %2 ms</translation>
    </message>
    <message>
        <source>B: %1, being drawn</source>
        <translation>B: %1, wird gezeichnet</translation>
    </message>
    <message>
        <source>B: being drawn</source>
        <translation>B: wird gezeichnet</translation>
    </message>
    <message>
        <source>B: cannot be drawn</source>
        <translation>B: kann nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>B: not drawn, because no view shows it</source>
        <translation>B: nicht gezeichnet, weil keine Ansicht es zeigt</translation>
    </message>
    <message>
        <source>back</source>
        <extracomment>tables</extracomment>
        <translation>hinten</translation>
    </message>
    <message>
        <source>Back print</source>
        <extracomment>tables</extracomment>
        <translation>Hinterer Druck</translation>
    </message>
    <message>
        <source>Backspace, Alt+Left</source>
        <translation>Rücktaste, Alt+Links</translation>
    </message>
    <message>
        <source>Backward</source>
        <extracomment>tables</extracomment>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Bake size</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung des Volumens</translation>
    </message>
    <message>
        <source>baked</source>
        <extracomment>tables</extracomment>
        <translation>gebacken</translation>
    </message>
    <message>
        <source>Baked light</source>
        <extracomment>tables</extracomment>
        <translation>Gebackenes Licht</translation>
    </message>
    <message>
        <source>baked light is switched off</source>
        <translation>gebackenes Licht ist ausgeschaltet</translation>
    </message>
    <message>
        <source>Ball density</source>
        <extracomment>tables</extracomment>
        <translation>Ball: Dichte</translation>
    </message>
    <message>
        <source>Ball length</source>
        <extracomment>tables</extracomment>
        <translation>Ball: Länge</translation>
    </message>
    <message>
        <source>Ball root</source>
        <extracomment>tables</extracomment>
        <translation>Ball: Wurzel</translation>
    </message>
    <message>
        <source>Ball thickness</source>
        <extracomment>tables</extracomment>
        <translation>Ball: Dicke</translation>
    </message>
    <message>
        <source>Ball tip</source>
        <extracomment>tables</extracomment>
        <translation>Ball: Spitze</translation>
    </message>
    <message>
        <source>Ball uniformity</source>
        <extracomment>tables</extracomment>
        <translation>Ball: Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>Bands</source>
        <extracomment>tables</extracomment>
        <translation>Tonstufen</translation>
    </message>
    <message>
        <source>banner in the beam</source>
        <translation>Banner im Strahl</translation>
    </message>
    <message>
        <source>Bar radius</source>
        <extracomment>tables</extracomment>
        <translation>Stabradius</translation>
    </message>
    <message>
        <source>bare scene, a part</source>
        <translation>nackte Szene, ein Teil</translation>
    </message>
    <message>
        <source>Bars</source>
        <extracomment>tables</extracomment>
        <translation>Stäbe</translation>
    </message>
    <message>
        <source>bars</source>
        <extracomment>tables</extracomment>
        <translation>Stäbe</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Base color</source>
        <extracomment>tables</extracomment>
        <translation>Grundfarbe</translation>
    </message>
    <message>
        <source>Base of the object: the free plinth of the hall, a plinth of its own, or the floor.</source>
        <extracomment>tables</extracomment>
        <translation>Standort des Objekts: der freie Sockel der Halle, ein eigener Sockel oder der Boden.</translation>
    </message>
    <message>
        <source>Base thickness</source>
        <extracomment>tables</extracomment>
        <translation>Bodendicke</translation>
    </message>
    <message>
        <source>Base width</source>
        <extracomment>tables</extracomment>
        <translation>Bodenbreite</translation>
    </message>
    <message>
        <source>Baseline scale</source>
        <translation>Maßstab der Basis</translation>
    </message>
    <message>
        <source>Beam strength</source>
        <extracomment>tables</extracomment>
        <translation>Strahlenstärke</translation>
    </message>
    <message>
        <source>Beams of the light itself, wherever one looks, with the shadows of what hangs in them.</source>
        <translation>Strahlen aus dem Licht selbst, wohin man auch schaut, mit den Schatten dessen, was in ihnen hängt.</translation>
    </message>
    <message>
        <source>because the new program does not build: {1}</source>
        <translation>weil sich das neue Programm nicht bauen lässt: {1}</translation>
    </message>
    <message>
        <source>behind a wall</source>
        <translation>hinter einer Wand</translation>
    </message>
    <message>
        <source>below</source>
        <translation>von unten</translation>
    </message>
    <message>
        <source>best view</source>
        <translation>beste Ansicht</translation>
    </message>
    <message>
        <source>Best within</source>
        <translation>Bestes innerhalb von</translation>
    </message>
    <message>
        <source>Between four settings</source>
        <translation>Zwischen vier Einstellungen</translation>
    </message>
    <message>
        <source>billow</source>
        <extracomment>tables</extracomment>
        <translation>bauschig</translation>
    </message>
    <message>
        <source>BIN chunk</source>
        <translation>BIN-Block</translation>
    </message>
    <message>
        <source>binary STL, millimeters: {1}</source>
        <translation>binäres STL, Millimeter: {=1}</translation>
    </message>
    <message>
        <source>Bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>Bits per channel.</source>
        <translation>Bits pro Kanal.</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Anschnitt</translation>
    </message>
    <message>
        <source>Blend</source>
        <extracomment>tables</extracomment>
        <translation>Verschmelzung</translation>
    </message>
    <message>
        <source>Blend width</source>
        <translation>Breite der Verschmelzung</translation>
    </message>
    <message>
        <source>Blinn-Phong</source>
        <extracomment>tables</extracomment>
        <translation>Blinn-Phong</translation>
    </message>
    <message>
        <source>blue noise</source>
        <extracomment>tables</extracomment>
        <translation>blaues Rauschen</translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation>Blaupause</translation>
    </message>
    <message>
        <source>Bob</source>
        <translation>Wippen</translation>
    </message>
    <message>
        <source>Bookmark %1 is where you are now.</source>
        <translation>Lesezeichen %1 ist, wo Sie jetzt sind.</translation>
    </message>
    <message>
        <source>Bookmark {1}</source>
        <translation>Lesezeichen {1}</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>both</source>
        <extracomment>tables</extracomment>
        <translation>beide</translation>
    </message>
    <message>
        <source>Both ends of the sweep are the same: all views would be; give two different values.</source>
        <translation>Beide Enden des Durchlaufs sind gleich: Alle Ansichten wären es; geben Sie zwei verschiedene Werte an.</translation>
    </message>
    <message>
        <source>both numbers of &quot;sin_cos&quot; must be above 0</source>
        <translation>beide Zahlen von „sin_cos“ müssen über 0 liegen</translation>
    </message>
    <message>
        <source>both radii are 0; give one that is not</source>
        <translation>beide Radien sind 0; geben Sie einen an, der es nicht ist</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>Bottom radius</source>
        <translation>Radius unten</translation>
    </message>
    <message>
        <source>Bounce light</source>
        <extracomment>tables</extracomment>
        <translation>Licht von unten</translation>
    </message>
    <message>
        <source>Bounce period</source>
        <extracomment>tables</extracomment>
        <translation>Sprungabstand</translation>
    </message>
    <message>
        <source>Bounces</source>
        <extracomment>tables</extracomment>
        <translation>Spiegelungen</translation>
    </message>
    <message>
        <source>Bounces of the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Spiegelungen der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Bound share</source>
        <extracomment>tables</extracomment>
        <translation>Anteil der Schranke</translation>
    </message>
    <message>
        <source>bounded</source>
        <extracomment>tables</extracomment>
        <translation>beschränkt</translation>
    </message>
    <message>
        <source>Bounding box</source>
        <extracomment>tables</extracomment>
        <translation>Hüllquader</translation>
    </message>
    <message>
        <source>bowl</source>
        <extracomment>tables</extracomment>
        <translation>Schale</translation>
    </message>
    <message>
        <source>Bowl bottom</source>
        <extracomment>tables</extracomment>
        <translation>Schalenboden</translation>
    </message>
    <message>
        <source>Bowl radius</source>
        <extracomment>tables</extracomment>
        <translation>Schalenradius</translation>
    </message>
    <message>
        <source>Bowl top</source>
        <extracomment>tables</extracomment>
        <translation>Schalenrand</translation>
    </message>
    <message>
        <source>Box size</source>
        <extracomment>tables</extracomment>
        <translation>Quadergröße</translation>
    </message>
    <message>
        <source>Boxes</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Brightness</source>
        <extracomment>tables</extracomment>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Brightness below which the sky gives no rays: 0 uses all of it, high only the brightest parts.</source>
        <extracomment>tables</extracomment>
        <translation>Helligkeit, unter der der Himmel keine Strahlen gibt: 0 nutzt ihn ganz, hohe Werte nur die hellsten Teile.</translation>
    </message>
    <message>
        <source>Brightness of the rays: each stop doubles it.</source>
        <extracomment>tables</extracomment>
        <translation>Helligkeit der Strahlen: Jede Blende verdoppelt sie.</translation>
    </message>
    <message>
        <source>Brightness of the stars: 0 shows none.</source>
        <extracomment>tables</extracomment>
        <translation>Helligkeit der Sterne: 0 zeigt keine.</translation>
    </message>
    <message>
        <source>Brightness of the whole picture, as a factor: 1 leaves it as it is.</source>
        <extracomment>tables</extracomment>
        <translation>Helligkeit des ganzen Bildes, als Faktor: 1 lässt es, wie es ist.</translation>
    </message>
    <message>
        <source>Brightness of the whole picture: each stop doubles it.</source>
        <extracomment>tables</extracomment>
        <translation>Helligkeit des ganzen Bildes: Jede Blende verdoppelt sie.</translation>
    </message>
    <message>
        <source>Broken by the banner</source>
        <translation>Vom Banner gebrochen</translation>
    </message>
    <message>
        <source>Buffer {1} names no data; it is zeros.</source>
        <translation>Puffer {1} nennt keine Daten; er besteht aus Nullen.</translation>
    </message>
    <message>
        <source>Build up</source>
        <extracomment>tables</extracomment>
        <translation>Aufbauen</translation>
    </message>
    <message>
        <source>built up to: {1}</source>
        <translation>aufgebaut bis: {1}</translation>
    </message>
    <message>
        <source>by angle</source>
        <extracomment>tables</extracomment>
        <translation>nach Winkel</translation>
    </message>
    <message>
        <source>By hand</source>
        <extracomment>tables</extracomment>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>bytes once unpacked</source>
        <translation>Bytes nach dem Entpacken</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>C64</source>
        <extracomment>tables</extracomment>
        <translation>C64</translation>
    </message>
    <message>
        <source>Calibration chart</source>
        <translation>Testchart</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Camera from which the scene is seen.</source>
        <translation>Kamera, von der aus die Szene gesehen wird.</translation>
    </message>
    <message>
        <source>Camera moves</source>
        <translation>Kamerabewegung</translation>
    </message>
    <message>
        <source>camera.fov {1}</source>
        <translation>camera.fov {1}</translation>
    </message>
    <message>
        <source>camera.{1} -&gt; {2} (allowed -{3} to {4} m)</source>
        <translation>camera.{=1} -&gt; {2} (erlaubt -{3} bis {4} m)</translation>
    </message>
    <message>
        <source>Cameras are not supported; their nodes become markers.</source>
        <translation>Kameras werden nicht unterstützt; ihre Knoten werden Marken.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Canceled; no file was written.</source>
        <translation>Abgebrochen; keine Datei wurde geschrieben.</translation>
    </message>
    <message>
        <source>Canceled; no table was written.</source>
        <translation>Abgebrochen; keine Tabelle wurde geschrieben.</translation>
    </message>
    <message>
        <source>Canceled; whole frames stay, a video leaves no file.</source>
        <translation>Abgebrochen; fertige Frames bleiben, ein Video hinterlässt keine Datei.</translation>
    </message>
    <message>
        <source>candies</source>
        <extracomment>tables</extracomment>
        <translation>Bonbons</translation>
    </message>
    <message>
        <source>Candle color</source>
        <extracomment>tables</extracomment>
        <translation>Kerzenfarbe</translation>
    </message>
    <message>
        <source>Candle strength</source>
        <extracomment>tables</extracomment>
        <translation>Kerzenstärke</translation>
    </message>
    <message>
        <source>Candles</source>
        <extracomment>tables</extracomment>
        <translation>Kerzen</translation>
    </message>
    <message>
        <source>Candy 1</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1</translation>
    </message>
    <message>
        <source>Candy 10, in the air</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10, in der Luft</translation>
    </message>
    <message>
        <source>Candy 2</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2</translation>
    </message>
    <message>
        <source>Candy 3</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3</translation>
    </message>
    <message>
        <source>Candy 4</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4</translation>
    </message>
    <message>
        <source>Candy 5</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5</translation>
    </message>
    <message>
        <source>Candy 6</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6</translation>
    </message>
    <message>
        <source>Candy 7</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7</translation>
    </message>
    <message>
        <source>Candy 8, in the air</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8, in der Luft</translation>
    </message>
    <message>
        <source>Candy 9, in the air</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9, in der Luft</translation>
    </message>
    <message>
        <source>Candy roughness</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit der Bonbons</translation>
    </message>
    <message>
        <source>Candy1 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: Wippen</translation>
    </message>
    <message>
        <source>Candy1 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: Farbe</translation>
    </message>
    <message>
        <source>Candy1 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: Rundung</translation>
    </message>
    <message>
        <source>Candy1 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: halbes x</translation>
    </message>
    <message>
        <source>Candy1 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: halbes y</translation>
    </message>
    <message>
        <source>Candy1 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: halbes z</translation>
    </message>
    <message>
        <source>Candy1 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: Drehung</translation>
    </message>
    <message>
        <source>Candy1 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: Taumeln</translation>
    </message>
    <message>
        <source>Candy1 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: x</translation>
    </message>
    <message>
        <source>Candy1 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: y</translation>
    </message>
    <message>
        <source>Candy1 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 1: z</translation>
    </message>
    <message>
        <source>Candy10 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: Wippen</translation>
    </message>
    <message>
        <source>Candy10 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: Farbe</translation>
    </message>
    <message>
        <source>Candy10 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: Rundung</translation>
    </message>
    <message>
        <source>Candy10 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: halbes x</translation>
    </message>
    <message>
        <source>Candy10 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: halbes y</translation>
    </message>
    <message>
        <source>Candy10 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: halbes z</translation>
    </message>
    <message>
        <source>Candy10 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: Drehung</translation>
    </message>
    <message>
        <source>Candy10 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: Taumeln</translation>
    </message>
    <message>
        <source>Candy10 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: x</translation>
    </message>
    <message>
        <source>Candy10 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: y</translation>
    </message>
    <message>
        <source>Candy10 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 10: z</translation>
    </message>
    <message>
        <source>Candy2 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: Wippen</translation>
    </message>
    <message>
        <source>Candy2 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: Farbe</translation>
    </message>
    <message>
        <source>Candy2 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: Rundung</translation>
    </message>
    <message>
        <source>Candy2 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: halbes x</translation>
    </message>
    <message>
        <source>Candy2 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: halbes y</translation>
    </message>
    <message>
        <source>Candy2 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: halbes z</translation>
    </message>
    <message>
        <source>Candy2 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: Drehung</translation>
    </message>
    <message>
        <source>Candy2 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: Taumeln</translation>
    </message>
    <message>
        <source>Candy2 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: x</translation>
    </message>
    <message>
        <source>Candy2 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: y</translation>
    </message>
    <message>
        <source>Candy2 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 2: z</translation>
    </message>
    <message>
        <source>Candy3 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: Wippen</translation>
    </message>
    <message>
        <source>Candy3 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: Farbe</translation>
    </message>
    <message>
        <source>Candy3 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: Rundung</translation>
    </message>
    <message>
        <source>Candy3 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: halbes x</translation>
    </message>
    <message>
        <source>Candy3 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: halbes y</translation>
    </message>
    <message>
        <source>Candy3 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: halbes z</translation>
    </message>
    <message>
        <source>Candy3 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: Drehung</translation>
    </message>
    <message>
        <source>Candy3 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: Taumeln</translation>
    </message>
    <message>
        <source>Candy3 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: x</translation>
    </message>
    <message>
        <source>Candy3 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: y</translation>
    </message>
    <message>
        <source>Candy3 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 3: z</translation>
    </message>
    <message>
        <source>Candy4 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: Wippen</translation>
    </message>
    <message>
        <source>Candy4 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: Farbe</translation>
    </message>
    <message>
        <source>Candy4 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: Rundung</translation>
    </message>
    <message>
        <source>Candy4 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: halbes x</translation>
    </message>
    <message>
        <source>Candy4 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: halbes y</translation>
    </message>
    <message>
        <source>Candy4 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: halbes z</translation>
    </message>
    <message>
        <source>Candy4 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: Drehung</translation>
    </message>
    <message>
        <source>Candy4 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: Taumeln</translation>
    </message>
    <message>
        <source>Candy4 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: x</translation>
    </message>
    <message>
        <source>Candy4 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: y</translation>
    </message>
    <message>
        <source>Candy4 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 4: z</translation>
    </message>
    <message>
        <source>Candy5 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: Wippen</translation>
    </message>
    <message>
        <source>Candy5 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: Farbe</translation>
    </message>
    <message>
        <source>Candy5 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: Rundung</translation>
    </message>
    <message>
        <source>Candy5 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: halbes x</translation>
    </message>
    <message>
        <source>Candy5 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: halbes y</translation>
    </message>
    <message>
        <source>Candy5 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: halbes z</translation>
    </message>
    <message>
        <source>Candy5 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: Drehung</translation>
    </message>
    <message>
        <source>Candy5 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: Taumeln</translation>
    </message>
    <message>
        <source>Candy5 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: x</translation>
    </message>
    <message>
        <source>Candy5 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: y</translation>
    </message>
    <message>
        <source>Candy5 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 5: z</translation>
    </message>
    <message>
        <source>Candy6 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: Wippen</translation>
    </message>
    <message>
        <source>Candy6 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: Farbe</translation>
    </message>
    <message>
        <source>Candy6 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: Rundung</translation>
    </message>
    <message>
        <source>Candy6 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: halbes x</translation>
    </message>
    <message>
        <source>Candy6 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: halbes y</translation>
    </message>
    <message>
        <source>Candy6 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: halbes z</translation>
    </message>
    <message>
        <source>Candy6 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: Drehung</translation>
    </message>
    <message>
        <source>Candy6 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: Taumeln</translation>
    </message>
    <message>
        <source>Candy6 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: x</translation>
    </message>
    <message>
        <source>Candy6 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: y</translation>
    </message>
    <message>
        <source>Candy6 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 6: z</translation>
    </message>
    <message>
        <source>Candy7 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: Wippen</translation>
    </message>
    <message>
        <source>Candy7 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: Farbe</translation>
    </message>
    <message>
        <source>Candy7 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: Rundung</translation>
    </message>
    <message>
        <source>Candy7 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: halbes x</translation>
    </message>
    <message>
        <source>Candy7 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: halbes y</translation>
    </message>
    <message>
        <source>Candy7 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: halbes z</translation>
    </message>
    <message>
        <source>Candy7 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: Drehung</translation>
    </message>
    <message>
        <source>Candy7 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: Taumeln</translation>
    </message>
    <message>
        <source>Candy7 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: x</translation>
    </message>
    <message>
        <source>Candy7 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: y</translation>
    </message>
    <message>
        <source>Candy7 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 7: z</translation>
    </message>
    <message>
        <source>Candy8 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: Wippen</translation>
    </message>
    <message>
        <source>Candy8 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: Farbe</translation>
    </message>
    <message>
        <source>Candy8 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: Rundung</translation>
    </message>
    <message>
        <source>Candy8 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: halbes x</translation>
    </message>
    <message>
        <source>Candy8 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: halbes y</translation>
    </message>
    <message>
        <source>Candy8 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: halbes z</translation>
    </message>
    <message>
        <source>Candy8 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: Drehung</translation>
    </message>
    <message>
        <source>Candy8 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: Taumeln</translation>
    </message>
    <message>
        <source>Candy8 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: x</translation>
    </message>
    <message>
        <source>Candy8 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: y</translation>
    </message>
    <message>
        <source>Candy8 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 8: z</translation>
    </message>
    <message>
        <source>Candy9 bob</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: Wippen</translation>
    </message>
    <message>
        <source>Candy9 color</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: Farbe</translation>
    </message>
    <message>
        <source>Candy9 corner</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: Rundung</translation>
    </message>
    <message>
        <source>Candy9 half x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: halbes x</translation>
    </message>
    <message>
        <source>Candy9 half y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: halbes y</translation>
    </message>
    <message>
        <source>Candy9 half z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: halbes z</translation>
    </message>
    <message>
        <source>Candy9 spin</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: Drehung</translation>
    </message>
    <message>
        <source>Candy9 tumble</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: Taumeln</translation>
    </message>
    <message>
        <source>Candy9 x</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: x</translation>
    </message>
    <message>
        <source>Candy9 y</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: y</translation>
    </message>
    <message>
        <source>Candy9 z</source>
        <extracomment>tables</extracomment>
        <translation>Bonbon 9: z</translation>
    </message>
    <message>
        <source>Cannot be opened</source>
        <translation>Kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Cannot change the value: the node no longer has it. Select another node.</source>
        <translation>Der Wert kann nicht geändert werden: Der Knoten hat ihn nicht mehr. Bitte einen anderen Knoten wählen.</translation>
    </message>
    <message>
        <source>Cannot change {1}: it is part of Vitrine; save a copy under another name.</source>
        <translation>{=1} kann nicht geändert werden: Es gehört zu Vitrine; speichern Sie eine Kopie unter einem anderen Namen.</translation>
    </message>
    <message>
        <source>Cannot compare {1}: {2}.</source>
        <translation>{1} lässt sich nicht vergleichen: {2}.</translation>
    </message>
    <message>
        <source>Cannot follow the reference &quot;{1}&quot; inside {2}: {3}; use a plain relative path.</source>
        <translation>Dem Verweis „{=1}“ in {=2} kann nicht gefolgt werden: {3}; verwenden Sie einen einfachen relativen Pfad.</translation>
    </message>
    <message>
        <source>Cannot import {1}: there is no preset in this picture; choose another.</source>
        <translation>{=1} kann nicht importiert werden: In diesem Bild steckt kein Preset; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Cannot keep the views in {1}: {2} failed ({3}); free some space there, or let TMPDIR name a folder with more.</source>
        <translation>Die Ansichten lassen sich nicht in {=1} aufbewahren: {2} ist misslungen ({=3}); geben Sie dort Platz frei, oder lassen Sie TMPDIR einen Ordner mit mehr davon nennen.</translation>
    </message>
    <message>
        <source>Cannot look at {1}: it carries no description of its sheet, and there is no {2} beside it; choose a file that vitrine print wrote.</source>
        <translation>{=1} kann nicht betrachtet werden: Er enthält keine Beschreibung seiner Folie, und daneben gibt es kein {=2}; wählen Sie eine Datei, die vitrine print geschrieben hat.</translation>
    </message>
    <message>
        <source>Cannot make the folder {1}: {2}; check your permissions, or give another --out.</source>
        <translation>Der Ordner {=1} lässt sich nicht anlegen: {2}; prüfen Sie Ihre Rechte, oder geben Sie ein anderes --out an.</translation>
    </message>
    <message>
        <source>Cannot make {1}: there is not enough memory for it; choose a smaller one.</source>
        <translation>{=1} kann nicht erzeugt werden: Der Speicher reicht dafür nicht; wählen Sie etwas Kleineres.</translation>
    </message>
    <message>
        <source>Cannot move {1} to {2}: {3}; check your permissions.</source>
        <translation>{=1} kann nicht nach {=2} verschoben werden: {3}; prüfen Sie Ihre Rechte.</translation>
    </message>
    <message>
        <source>Cannot open {1}, which {2}: it is not beside the program; install {3} or build Vitrine again.</source>
        <translation>{=1} kann nicht geöffnet werden; die Bibliothek {2}. Sie liegt nicht neben dem Programm; installieren Sie {3}, oder bauen Sie Vitrine neu.</translation>
    </message>
    <message>
        <source>Cannot open {1}, which {2}: {3}install {4} or build Vitrine again.</source>
        <translation>{=1} kann nicht geöffnet werden; die Bibliothek {2}. {3}Installieren Sie {4}, oder bauen Sie Vitrine neu.</translation>
    </message>
    <message>
        <source>Cannot open {1}: there is no such file; check the name.</source>
        <translation>{=1} kann nicht geöffnet werden: Eine solche Datei gibt es nicht; prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>Cannot place a picture by &quot;{1}&quot;: this is not PICTURE:TURN,RIGHT,DOWN; give the picture's number, degrees clockwise (-360 to 360) and percent of the view's width and height (-100 to 100), such as 3:1.5,2,-0.5.</source>
        <translation>„{1}“ gibt keine Lage eines Bildes an: Das ist nicht PICTURE:TURN,RIGHT,DOWN; geben Sie die Nummer des Bildes, Grad im Uhrzeigersinn (-360 bis 360) und Prozent der Breite und Höhe der Ansicht an (-100 bis 100), etwa 3:1.5,2,-0.5.</translation>
    </message>
    <message>
        <source>Cannot place picture {1}: the last picture is number {2}; correct its number.</source>
        <translation>Bild {1} kann nicht verschoben oder gedreht werden: Das letzte Bild hat die Nummer {2}; korrigieren Sie die Nummer.</translation>
    </message>
    <message>
        <source>Cannot read the folder {1}: {2}.</source>
        <translation>Der Ordner {=1} kann nicht gelesen werden: {2}.</translation>
    </message>
    <message>
        <source>Cannot read {1}: it is neither a TIFF nor a PNG.</source>
        <translation>{=1} kann nicht gelesen werden: weder ein TIFF noch ein PNG.</translation>
    </message>
    <message>
        <source>Cannot read {1}: it is not glTF; export it again.</source>
        <translation>{=1} kann nicht gelesen werden: Es ist kein glTF; exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>Cannot read {1}: the file is too large; simplify the model.</source>
        <translation>{=1} kann nicht gelesen werden: Die Datei ist zu groß; vereinfachen Sie das Modell.</translation>
    </message>
    <message>
        <source>Cannot read {1}: there is no such file.</source>
        <translation>{=1} kann nicht gelesen werden: Eine solche Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>Cannot read {1}: there is not enough memory for it; choose a smaller one.</source>
        <translation>{=1} kann nicht gelesen werden: Der Speicher reicht dafür nicht; wählen Sie etwas Kleineres.</translation>
    </message>
    <message>
        <source>Cannot read {1}: this is not a glTF file; choose another file.</source>
        <translation>{=1} kann nicht gelesen werden: dies ist keine glTF-Datei; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read {1}: {2}</source>
        <translation>{=1} kann nicht gelesen werden: {2}</translation>
    </message>
    <message>
        <source>Cannot read {1}: {2}.</source>
        <translation>{=1} kann nicht gelesen werden: {2}.</translation>
    </message>
    <message>
        <source>Cannot read {1}: {2}; choose another file.</source>
        <translation>{=1} kann nicht gelesen werden: {2}; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>Cannot read {1}: {2}; choose another picture.</source>
        <translation>{=1} kann nicht gelesen werden: {2}; wählen Sie ein anderes Bild.</translation>
    </message>
    <message>
        <source>Cannot read {1}: {2}; export it again.</source>
        <translation>{=1} kann nicht gelesen werden: {2}; exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>Cannot write JSON: the text is not UTF-8.</source>
        <translation>JSON kann nicht geschrieben werden: Der Text ist kein UTF-8.</translation>
    </message>
    <message>
        <source>Cannot write JSON: the value {1}</source>
        <translation>JSON kann nicht geschrieben werden: Der Wert {1}</translation>
    </message>
    <message>
        <source>Cannot write JSON: {1} {2}</source>
        <translation>JSON kann nicht geschrieben werden: {=1} {2}</translation>
    </message>
    <message>
        <source>Cannot write {1}: give a name that ends in {2}</source>
        <translation>{=1} kann nicht geschrieben werden: Geben Sie einen Namen an, der auf {2} endet</translation>
    </message>
    <message>
        <source>Cannot write {1}: there is no folder {2}; create it first.</source>
        <translation>{=1} kann nicht geschrieben werden: Es gibt keinen Ordner {=2}; legen Sie ihn zuerst an.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2}</source>
        <translation>{=1} kann nicht geschrieben werden: {2}</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2} failed ({3}); the old content is untouched; {4}.</source>
        <translation>{=1} kann nicht geschrieben werden: {2} ist misslungen ({=3}); der alte Inhalt ist unberührt; {4}.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2} x {3} pixels are too many for this format, which ends at {4} per side; print it in parts.</source>
        <translation>{=1} kann nicht geschrieben werden: {2} x {3} Pixel sind zu viele für dieses Format, das bei {4} pro Seite endet; drucken Sie es in Teilen.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2}.</source>
        <translation>{=1} kann nicht geschrieben werden: {2}.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2}; choose another folder.</source>
        <translation>{=1} kann nicht geschrieben werden: {2}; wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2}; the old content is untouched; choose another kind of file, such as .apng.</source>
        <translation>{=1} kann nicht geschrieben werden: {2}; der alte Inhalt ist unberührt; wählen Sie eine andere Art von Datei, etwa .apng.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2}; the old content is untouched; free some space or choose another disk.</source>
        <translation>{=1} kann nicht geschrieben werden: {2}; der alte Inhalt ist unberührt; geben Sie Platz frei, oder wählen Sie einen anderen Datenträger.</translation>
    </message>
    <message>
        <source>Cannot write {1}: {2}; try a smaller picture.</source>
        <translation>{=1} kann nicht geschrieben werden: {2}; versuchen Sie ein kleineres Bild.</translation>
    </message>
    <message>
        <source>Carpet</source>
        <translation>Teppich</translation>
    </message>
    <message>
        <source>Cat</source>
        <translation>Katze</translation>
    </message>
    <message>
        <source>Cells near the surface</source>
        <translation>Zellen nahe der Oberfläche</translation>
    </message>
    <message>
        <source>Cells of {1} m are too small for a scene that reaches {2} m; give --cell {3}m or more.</source>
        <translation>Zellen von {=1} m sind zu klein für eine Szene, die {=2} m weit reicht; geben Sie --cell {=3}m oder mehr an.</translation>
    </message>
    <message>
        <source>Cells whose lanterns a step of a ray tests: its own, 2 x 2 or 3 x 3 cells, which cut off lanterns beyond, or cell by cell up to each wall, which is exact.</source>
        <extracomment>tables</extracomment>
        <translation>Zellen, deren Laternen ein Schritt eines Strahls prüft: die eigene, 2 x 2 oder 3 x 3 Zellen, was Laternen dahinter abschneidet, oder Zelle für Zelle bis zur Wand, was exakt ist.</translation>
    </message>
    <message>
        <source>cellular</source>
        <extracomment>tables</extracomment>
        <translation>zellular</translation>
    </message>
    <message>
        <source>center</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>central</source>
        <extracomment>tables</extracomment>
        <translation>zentral</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Change %1 of all together</source>
        <translation>%1 aller zusammen ändern</translation>
    </message>
    <message>
        <source>Change kind</source>
        <translation>Art ändern</translation>
    </message>
    <message>
        <source>Change settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>change squared over its mean</source>
        <translation>Änderung im Quadrat über ihrem Mittel</translation>
    </message>
    <message>
        <source>Change the tree</source>
        <translation>Den Baum ändern</translation>
    </message>
    <message>
        <source>Change the value, like the arrow keys</source>
        <translation>Den Wert ändern, wie die Pfeiltasten</translation>
    </message>
    <message>
        <source>Change the value; Shift ten times finer, Ctrl ten times coarser</source>
        <translation>Den Wert ändern; Umschalt zehnmal feiner, Strg zehnmal gröber</translation>
    </message>
    <message>
        <source>Change the views so that the sheet's mixing of them shows less; costs contrast.</source>
        <translation>Ändert die Ansichten so, dass man weniger davon sieht, wie die Folie sie mischt; kostet Kontrast.</translation>
    </message>
    <message>
        <source>Change where the views come from</source>
        <translation>Herkunft der Ansichten ändern</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Changed parameters:</source>
        <translation>Geänderte Parameter:</translation>
    </message>
    <message>
        <source>Changed since</source>
        <translation>Seither geändert</translation>
    </message>
    <message>
        <source>changes a pixel by at most {1}</source>
        <translation>ändert ein Pixel um höchstens {1}</translation>
    </message>
    <message>
        <source>changes a pixel by at most {1} % of its light</source>
        <translation>ändert ein Pixel um höchstens {1} % seines Lichts</translation>
    </message>
    <message>
        <source>changes a pixel by at most {1} % of its light and {2}</source>
        <translation>ändert ein Pixel um höchstens {1} % seines Lichts und {2}</translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation>ändert nichts</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Testchart</translation>
    </message>
    <message>
        <source>Chart span</source>
        <translation>Spanne des Charts</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Cheapest within error</source>
        <translation>Billigstes im Fehler von</translation>
    </message>
    <message>
        <source>check of the reference, {1}</source>
        <translation>Prüfung der Referenz, {1}</translation>
    </message>
    <message>
        <source>check that the folder exists</source>
        <translation>prüfen Sie, ob der Ordner existiert</translation>
    </message>
    <message>
        <source>checking its size</source>
        <translation>das Prüfen der Größe</translation>
    </message>
    <message>
        <source>Chocolate with sprinkles</source>
        <translation>Schokolade mit Streuseln</translation>
    </message>
    <message>
        <source>Choose a color; the picture follows.</source>
        <translation>Farbe wählen; das Bild folgt.</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose a file for %1</source>
        <translation>Datei für %1 wählen</translation>
    </message>
    <message>
        <source>Choose a file. Dropping one here works too.</source>
        <translation>Datei wählen. Sie lässt sich auch hier ablegen.</translation>
    </message>
    <message>
        <source>Choose a folder or pictures, or drop them here.</source>
        <translation>Wählen Sie einen Ordner oder Bilder, oder legen Sie sie hier ab.</translation>
    </message>
    <message>
        <source>choose a folder you may write to</source>
        <translation>wählen Sie einen Ordner, in den Sie schreiben dürfen</translation>
    </message>
    <message>
        <source>Choose a parameter</source>
        <translation>Einen Parameter wählen</translation>
    </message>
    <message>
        <source>Choose a parameter, then Measure. Errors are against its most exact value; costs are time and counted work.</source>
        <translation>Wählen Sie einen Parameter, dann „Messen“. Fehler gelten gegenüber seinem genauesten Wert; Kosten sind Zeit und gezählte Arbeit.</translation>
    </message>
    <message>
        <source>Choose a picture with a grid of views, or drop it here.</source>
        <translation>Wählen Sie ein Bild mit einem Raster von Ansichten, oder legen Sie es hier ab.</translation>
    </message>
    <message>
        <source>choose a shorter name</source>
        <translation>wählen Sie einen kürzeren Namen</translation>
    </message>
    <message>
        <source>Choose one of: %1.</source>
        <translation>Möglich sind: %1.</translation>
    </message>
    <message>
        <source>Choose sheet %1</source>
        <translation>Folie %1 wählen</translation>
    </message>
    <message>
        <source>Choose views</source>
        <translation>Ansichten wählen</translation>
    </message>
    <message>
        <source>Chop</source>
        <extracomment>tables</extracomment>
        <translation>Zuspitzung</translation>
    </message>
    <message>
        <source>Chosen: %1, error %2, cost %3.</source>
        <translation>Gewählt: %1, Fehler %2, Kosten %3.</translation>
    </message>
    <message>
        <source>chunk number {1}</source>
        <translation>Block Nummer {1}</translation>
    </message>
    <message>
        <source>classic</source>
        <extracomment>tables</extracomment>
        <translation>klassisch</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>klar</translation>
    </message>
    <message>
        <source>Clear the list now</source>
        <translation>Die Liste jetzt leeren</translation>
    </message>
    <message>
        <source>Clears the list of recent files; the files themselves are kept.</source>
        <translation>Leert die Liste der zuletzt geöffneten Dateien; die Dateien selbst bleiben.</translation>
    </message>
    <message>
        <source>clears the picture</source>
        <translation>leert das Bild am Anfang</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Click a shape in the picture, or a node above.</source>
        <translation>Klicken Sie eine Form im Bild an, oder oben einen Knoten.</translation>
    </message>
    <message>
        <source>Click a variation to use it. Parameters and groups that are locked in their menus keep their values.</source>
        <translation>Ein Klick übernimmt eine Variation. Parameter und Gruppen, die in ihren Menüs gesperrt sind, behalten ihre Werte.</translation>
    </message>
    <message>
        <source>Click a variation, or select it with the arrow keys and press Enter, to use it. Can be undone.</source>
        <translation>Ein Klick übernimmt eine Variation; ebenso Pfeiltasten und Eingabe. Lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Click, or any digit</source>
        <translation>Klick, oder eine Ziffer</translation>
    </message>
    <message>
        <source>Clock: %1, %2.</source>
        <translation>Uhr: %1, %2.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close %1</source>
        <translation>%1 schließen</translation>
    </message>
    <message>
        <source>Close all</source>
        <translation>Alle schließen</translation>
    </message>
    <message>
        <source>Close the window?</source>
        <translation>Fenster schließen?</translation>
    </message>
    <message>
        <source>close up</source>
        <translation>ganz nah</translation>
    </message>
    <message>
        <source>Close when it is done</source>
        <translation>Schließen, sobald es fertig ist</translation>
    </message>
    <message>
        <source>Close without saving</source>
        <translation>Schließen, ohne zu speichern</translation>
    </message>
    <message>
        <source>closed form</source>
        <extracomment>tables</extracomment>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>Closes the window. The session is restored at the next start.</source>
        <translation>Schließt das Fenster. Beim nächsten Start ist die Sitzung wieder da.</translation>
    </message>
    <message>
        <source>closing it failed ({1})</source>
        <translation>das Schließen ist misslungen ({=1})</translation>
    </message>
    <message>
        <source>cloths cover the empty places</source>
        <translation>Tücher bedecken die leeren Plätze</translation>
    </message>
    <message>
        <source>Cloud noise</source>
        <extracomment>tables</extracomment>
        <translation>Wolkenrauschen</translation>
    </message>
    <message>
        <source>Cloud octaves</source>
        <extracomment>tables</extracomment>
        <translation>Wolkenoktaven</translation>
    </message>
    <message>
        <source>Cloud steps</source>
        <extracomment>tables</extracomment>
        <translation>Wolkenschritte</translation>
    </message>
    <message>
        <source>Clouds</source>
        <extracomment>tables</extracomment>
        <translation>Wolken</translation>
    </message>
    <message>
        <source>clouds</source>
        <extracomment>tables</extracomment>
        <translation>Wolken</translation>
    </message>
    <message>
        <source>Clump</source>
        <extracomment>tables</extracomment>
        <translation>Büschel</translation>
    </message>
    <message>
        <source>Clump size</source>
        <extracomment>tables</extracomment>
        <translation>Büschelgröße</translation>
    </message>
    <message>
        <source>Coarse, 20 lenses an inch</source>
        <translation>Grob, 20 Linsen je Zoll</translation>
    </message>
    <message>
        <source>Coat of the ball</source>
        <extracomment>tables</extracomment>
        <translation>Fell des Balls</translation>
    </message>
    <message>
        <source>Coat of the ring</source>
        <extracomment>tables</extracomment>
        <translation>Fell des Rings</translation>
    </message>
    <message>
        <source>Coat of the roll</source>
        <extracomment>tables</extracomment>
        <translation>Fell der Rolle</translation>
    </message>
    <message>
        <source>collar</source>
        <extracomment>tables</extracomment>
        <translation>Kragen</translation>
    </message>
    <message>
        <source>Collar height</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des Kragens</translation>
    </message>
    <message>
        <source>Collar radius</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Kragens</translation>
    </message>
    <message>
        <source>Collar top</source>
        <extracomment>tables</extracomment>
        <translation>Kragen oben</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Color above, as linear values.</source>
        <translation>Farbe oben, in linearen Werten.</translation>
    </message>
    <message>
        <source>Color at the horizon, as linear values.</source>
        <translation>Farbe am Horizont, in linearen Werten.</translation>
    </message>
    <message>
        <source>Color below, as linear values.</source>
        <translation>Farbe unten, in linearen Werten.</translation>
    </message>
    <message>
        <source>Color by</source>
        <extracomment>tables</extracomment>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Color of all sprinkles.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe aller Streusel.</translation>
    </message>
    <message>
        <source>Color of deep water in daylight.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe tiefen Wassers bei Tageslicht.</translation>
    </message>
    <message>
        <source>Color of deep water.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe tiefen Wassers.</translation>
    </message>
    <message>
        <source>Color of the background at the bottom.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Hintergrunds unten.</translation>
    </message>
    <message>
        <source>Color of the background at the top.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Hintergrunds oben.</translation>
    </message>
    <message>
        <source>Color of the candy.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Bonbons.</translation>
    </message>
    <message>
        <source>Color of the dark lines.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der dunklen Linien.</translation>
    </message>
    <message>
        <source>Color of the dust, as the share of light that it scatters rather than absorbs: white absorbs none.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Staubs, als Anteil des Lichts, den er streut statt absorbiert: Weiß absorbiert nichts.</translation>
    </message>
    <message>
        <source>Color of the flames' light.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Lichts der Flammen.</translation>
    </message>
    <message>
        <source>Color of the fog at the horizon.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Nebels am Horizont.</translation>
    </message>
    <message>
        <source>Color of the glaze, of the metal, or of 10 cm of the glass.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der Glasur, des Metalls oder von 10 cm des Glases.</translation>
    </message>
    <message>
        <source>Color of the lamp in front of the niche.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der Lampe vor der Nische.</translation>
    </message>
    <message>
        <source>Color of the light lines.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der hellen Linien.</translation>
    </message>
    <message>
        <source>Color of the light that fills shadows from below.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Lichts, das Schatten von unten aufhellt.</translation>
    </message>
    <message>
        <source>Color of the paper, as the share of light that it does not absorb.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Papiers, als Anteil des Lichts, den es nicht absorbiert.</translation>
    </message>
    <message>
        <source>Color of the plinth.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Sockels.</translation>
    </message>
    <message>
        <source>Color of the rays, multiplied with the sun's own.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der Strahlen, multipliziert mit der Farbe der Sonne.</translation>
    </message>
    <message>
        <source>Color of the reference's ambient light, of which more comes from above.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Umgebungslichts der Referenz, von dem mehr von oben kommt.</translation>
    </message>
    <message>
        <source>Color of the reference's sun.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der Sonne der Referenz.</translation>
    </message>
    <message>
        <source>Color of the sand in white light.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Sandes in weißem Licht.</translation>
    </message>
    <message>
        <source>Color of the sky's light, which fills shadows from above.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Himmelslichts, das Schatten von oben aufhellt.</translation>
    </message>
    <message>
        <source>Color of the sunlight.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe des Sonnenlichts.</translation>
    </message>
    <message>
        <source>Color of the wafer.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe der Waffel.</translation>
    </message>
    <message>
        <source>Color of this coat at the skin.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe dieses Fells an der Haut.</translation>
    </message>
    <message>
        <source>Color of this coat at the tips of the strands.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe dieses Fells an den Haarspitzen.</translation>
    </message>
    <message>
        <source>Color of this layer.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe dieser Schicht.</translation>
    </message>
    <message>
        <source>Color of white light after 10 cm of the glass.</source>
        <extracomment>tables</extracomment>
        <translation>Farbe weißen Lichts nach 10 cm des Glases.</translation>
    </message>
    <message>
        <source>Color temperature of the lamps: low is candlelight, high is bluish.</source>
        <extracomment>tables</extracomment>
        <translation>Farbtemperatur der Lampen: Niedrige Werte sind Kerzenlicht, hohe sind bläulich.</translation>
    </message>
    <message>
        <source>Color temperature of the sky's light: high is bluer.</source>
        <extracomment>tables</extracomment>
        <translation>Farbtemperatur des Himmelslichts: Hohe Werte sind blauer.</translation>
    </message>
    <message>
        <source>Color temperature of the sunlight: low is the red of evening, high is bluish.</source>
        <extracomment>tables</extracomment>
        <translation>Farbtemperatur des Sonnenlichts: Niedrige Werte sind das Rot des Abends, hohe sind bläulich.</translation>
    </message>
    <message>
        <source>Color variation</source>
        <extracomment>tables</extracomment>
        <translation>Farbstreuung</translation>
    </message>
    <message>
        <source>Color, as linear values.</source>
        <translation>Farbe, in linearen Werten.</translation>
    </message>
    <message>
        <source>Colored outline</source>
        <extracomment>tables</extracomment>
        <translation>Farbiger Umriss</translation>
    </message>
    <message>
        <source>Colors</source>
        <extracomment>tables</extracomment>
        <translation>Farben</translation>
    </message>
    <message>
        <source>colors</source>
        <extracomment>tables</extracomment>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Colors of panels and dialogs. “As the desktop” also follows its contrast setting; high contrast is light or dark like the desktop.</source>
        <translation>Farben von Bedienfeldern und Dialogen. „Wie der Desktop“ übernimmt auch dessen Kontrast; hoher Kontrast ist hell oder dunkel wie der Desktop.</translation>
    </message>
    <message>
        <source>Colors of the hall</source>
        <translation>Farben der Halle</translation>
    </message>
    <message>
        <source>Colors of the sprinkles: those of the first five candies, or a single one.</source>
        <extracomment>tables</extracomment>
        <translation>Farben der Streusel: die der ersten fünf Bonbons oder eine einzige.</translation>
    </message>
    <message>
        <source>Colors spread</source>
        <translation>Farben gefächert</translation>
    </message>
    <message>
        <source>columns x rows of views</source>
        <translation>Spalten x Reihen von Ansichten</translation>
    </message>
    <message>
        <source>Comb</source>
        <extracomment>tables</extracomment>
        <translation>Kämmen</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Come nearer to the exhibit or step back</source>
        <translation>Näher an das Exponat heran oder zurück</translation>
    </message>
    <message>
        <source>Come nearer to the exhibit, or step back</source>
        <translation>Näher an das Exponat heran, oder zurück</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>Befehle und ihre Tastenkürzel</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message numerus="yes">
        <source>Compare %n</source>
        <translation>
            <numerusform>%n vergleichen</numerusform>
            <numerusform>%n vergleichen</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare the ticked studies</source>
        <translation>Die angehakten Studien vergleichen</translation>
    </message>
    <message>
        <source>Compare with: %1</source>
        <translation>Vergleichen mit: %1</translation>
    </message>
    <message>
        <source>compare-settings: give either a second setting or --with, not both.</source>
        <translation>compare-settings: Geben Sie entweder eine zweite Einstellung oder --with an, nicht beides.</translation>
    </message>
    <message>
        <source>compare-settings: name a second setting, or what A is compared --with.</source>
        <translation>compare-settings: Nennen Sie eine zweite Einstellung, oder mit --with, womit A verglichen wird.</translation>
    </message>
    <message>
        <source>compare-studies: give files of two to {1} studies; there are {2}</source>
        <translation>compare-studies: Geben Sie Dateien von zwei bis {=1} Studien an; es sind {=2}</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Verglichen mit</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Comparison of A and B</source>
        <translation>Vergleich von A und B</translation>
    </message>
    <message>
        <source>Compensate</source>
        <translation>Ausgleichen</translation>
    </message>
    <message>
        <source>Compensate cross-talk</source>
        <translation>Übersprechen ausgleichen</translation>
    </message>
    <message>
        <source>Compiles changed shaders again; if one fails, the last good picture is kept.</source>
        <translation>Übersetzt geänderte Shader neu; misslingt es, bleibt das letzte gute Bild.</translation>
    </message>
    <message>
        <source>composition</source>
        <translation>Komposition</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Kompression</translation>
    </message>
    <message>
        <source>Compression of a TIFF: none is what every print shop reads. PNG is always compressed.</source>
        <translation>Kompression eines TIFF: ohne liest jede Druckerei. PNG ist immer komprimiert.</translation>
    </message>
    <message>
        <source>Compression of the fur where it touches something: 0 carries the body on its tips, 1 lets the skin down to the ground.</source>
        <extracomment>tables</extracomment>
        <translation>Wie stark das Fell bei Berührung gedrückt wird: 0 trägt den Körper auf den Spitzen, 1 lässt die Haut bis zum Boden.</translation>
    </message>
    <message>
        <source>compute</source>
        <translation>Compute</translation>
    </message>
    <message>
        <source>Computing the charts …</source>
        <translation>Die Diagramme werden berechnet …</translation>
    </message>
    <message>
        <source>Cone prepass</source>
        <extracomment>tables</extracomment>
        <translation>Kegel-Vorlauf</translation>
    </message>
    <message>
        <source>cones</source>
        <extracomment>tables</extracomment>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Conic</source>
        <extracomment>tables</extracomment>
        <translation>Konische Konstante</translation>
    </message>
    <message>
        <source>Conic constant of a custom lens: 0 is a circle, -0.41 the ellipse that is sharp straight ahead.</source>
        <extracomment>tables</extracomment>
        <translation>Konische Konstante einer eigenen Linse: 0 ist ein Kreis, -0.41 die Ellipse, die geradeaus scharf ist.</translation>
    </message>
    <message>
        <source>Conic constant of the lenses: 0 is a circle, -1/n² the ellipse without spherical aberration.</source>
        <translation>Konische Konstante der Linsen: 0 ist ein Kreis, -1/n² die Ellipse ohne sphärische Aberration.</translation>
    </message>
    <message>
        <source>Console of 1983</source>
        <translation>Konsole von 1983</translation>
    </message>
    <message>
        <source>constant buffers</source>
        <translation>Konstantenpuffer</translation>
    </message>
    <message>
        <source>Contact shadows</source>
        <extracomment>tables</extracomment>
        <translation>Kontaktschatten</translation>
    </message>
    <message>
        <source>contact shadows are switched off</source>
        <translation>Kontaktschatten sind ausgeschaltet</translation>
    </message>
    <message>
        <source>Content of a strip: the one color that its lens shows (flat), or its slice of the view, squeezed as in the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Inhalt eines Streifens: die eine Farbe, die seine Linse zeigt (flach), oder sein Ausschnitt der Ansicht, gestaucht wie in der Referenz.</translation>
    </message>
    <message>
        <source>Contrast</source>
        <extracomment>tables</extracomment>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>converting a frame</source>
        <translation>das Umwandeln eines Frames</translation>
    </message>
    <message>
        <source>Copied a command line that renders this picture into picture.png.</source>
        <translation>Eine Befehlszeile wurde kopiert, die dieses Bild in picture.png rendert.</translation>
    </message>
    <message>
        <source>Copies a command line that renders the identical picture in a terminal.</source>
        <translation>Kopiert eine Befehlszeile, die im Terminal genau dasselbe Bild rendert.</translation>
    </message>
    <message>
        <source>Copies a preset file to your own presets.</source>
        <translation>Kopiert eine Preset-Datei zu Ihren eigenen Presets.</translation>
    </message>
    <message>
        <source>Copies all settings of A to B. Can be undone.</source>
        <translation>Kopiert alle Einstellungen von A nach B. Lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Copies all settings of B to A. Can be undone.</source>
        <translation>Kopiert alle Einstellungen von B nach A. Lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Copies of the child around the y axis; the first is the child itself.</source>
        <translation>Kopien des Kindes um die y-Achse; die erste ist das Kind selbst.</translation>
    </message>
    <message>
        <source>Copies of the child on a grid around the origin.</source>
        <translation>Kopien des Kindes auf einem Gitter um den Ursprung.</translation>
    </message>
    <message>
        <source>Copies points and differences as a table (CSV).</source>
        <translation>Kopiert Punkte und Unterschiede als Tabelle (CSV).</translation>
    </message>
    <message>
        <source>Copies the picture to the clipboard.</source>
        <translation>Kopiert das Bild in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Copies the selected preset to a preset of your own.</source>
        <translation>Kopiert das gewählte Preset in ein eigenes.</translation>
    </message>
    <message>
        <source>Copies what was measured as a table (CSV).</source>
        <translation>Kopiert das Gemessene als Tabelle (CSV).</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy %1 from B</source>
        <translation>%1 von B übernehmen</translation>
    </message>
    <message>
        <source>Copy %1 to B</source>
        <translation>%1 nach B kopieren</translation>
    </message>
    <message>
        <source>Copy a group</source>
        <translation>Eine Gruppe kopieren</translation>
    </message>
    <message>
        <source>Copy a group to the others</source>
        <translation>Eine Gruppe in die anderen kopieren</translation>
    </message>
    <message>
        <source>Copy all &amp;to B</source>
        <translation>Alles nach B &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy all as JSON</source>
        <translation>Alle als JSON kopieren</translation>
    </message>
    <message>
        <source>Copy all fro&amp;m B</source>
        <translation>Alles v&amp;on B übernehmen</translation>
    </message>
    <message>
        <source>Copy all from B</source>
        <translation>Alles von B übernehmen</translation>
    </message>
    <message>
        <source>Copy all to B</source>
        <translation>Alles nach B kopieren</translation>
    </message>
    <message>
        <source>Copy as command &amp;line</source>
        <translation>Als B&amp;efehlszeile kopieren</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>Copy from %1</source>
        <translation>Von %1 kopieren</translation>
    </message>
    <message>
        <source>Copy from B: %1</source>
        <translation>Von B übernehmen: %1</translation>
    </message>
    <message>
        <source>Copy the measurements</source>
        <translation>Messwerte kopieren</translation>
    </message>
    <message>
        <source>Copy the ticked as a table</source>
        <translation>Die angehakten als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Copy this message</source>
        <translation>Diese Meldung kopieren</translation>
    </message>
    <message>
        <source>Copy to B</source>
        <translation>Nach B kopieren</translation>
    </message>
    <message>
        <source>Copy to the others</source>
        <translation>In die anderen kopieren</translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation>Wert kopieren</translation>
    </message>
    <message>
        <source>Corner</source>
        <extracomment>tables</extracomment>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Corner of the part that is meshed and cut there; without it, the whole scene.</source>
        <translation>Ecke des Teils, der vernetzt und dort abgeschnitten wird; ohne sie die ganze Szene.</translation>
    </message>
    <message>
        <source>cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>Costs</source>
        <extracomment>tables</extracomment>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>Costs of the chart</source>
        <translation>Kosten im Diagramm</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Count that the heat map shows in white: low brings out small costs, high large ones.</source>
        <extracomment>tables</extracomment>
        <translation>Zählwert, den die Heatmap weiß zeigt: Niedrige Werte zeigen kleine Kosten, hohe große.</translation>
    </message>
    <message>
        <source>Counted work</source>
        <translation>Gezählte Arbeit</translation>
    </message>
    <message>
        <source>counted work</source>
        <translation>gezählte Arbeit</translation>
    </message>
    <message>
        <source>Coverage</source>
        <extracomment>tables</extracomment>
        <translation>Bedeckung</translation>
    </message>
    <message>
        <source>Cream roughness</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit des Eises</translation>
    </message>
    <message>
        <source>creating a file beside it</source>
        <translation>das Anlegen einer Datei daneben</translation>
    </message>
    <message>
        <source>creating a file there</source>
        <translation>das Anlegen einer Datei dort</translation>
    </message>
    <message>
        <source>creating it</source>
        <translation>das Anlegen</translation>
    </message>
    <message>
        <source>creating it failed ({1})</source>
        <translation>das Anlegen ist misslungen ({=1})</translation>
    </message>
    <message>
        <source>Crepuscular Rays</source>
        <translation>Strahlenbüschel</translation>
    </message>
    <message>
        <source>crop</source>
        <translation>beschneiden</translation>
    </message>
    <message>
        <source>Cross left, right</source>
        <translation>Kreuz links, rechts</translation>
    </message>
    <message>
        <source>Cross up, down</source>
        <translation>Kreuz auf, ab</translation>
    </message>
    <message>
        <source>Cross-talk</source>
        <translation>Übersprechen</translation>
    </message>
    <message>
        <source>Cross-talk %1 to %2 %</source>
        <translation>Übersprechen %1 bis %2 %</translation>
    </message>
    <message>
        <source>Cross-talk of every view</source>
        <translation>Übersprechen jeder Ansicht</translation>
    </message>
    <message>
        <source>Crowding</source>
        <extracomment>tables</extracomment>
        <translation>Belegung</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Ctrl and arrows</source>
        <translation>Strg und Pfeiltasten</translation>
    </message>
    <message>
        <source>Cube map of six square pictures.</source>
        <translation>Würfelkarte aus sechs quadratischen Bildern.</translation>
    </message>
    <message>
        <source>cube map of the reference</source>
        <translation>Würfelbild der Referenz</translation>
    </message>
    <message>
        <source>Curl</source>
        <extracomment>tables</extracomment>
        <translation>Locken</translation>
    </message>
    <message>
        <source>Curl turns</source>
        <extracomment>tables</extracomment>
        <translation>Lockenwindungen</translation>
    </message>
    <message>
        <source>Current settings</source>
        <translation>Jetzige Einstellungen</translation>
    </message>
    <message>
        <source>Curvature</source>
        <extracomment>tables</extracomment>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Curvature of the strands: 0 leans them like straight sticks, high bends only the tips.</source>
        <extracomment>tables</extracomment>
        <translation>Krümmung der Haare: 0 lehnt sie wie gerade Stöcke, hohe Werte biegen nur die Spitzen.</translation>
    </message>
    <message>
        <source>custom</source>
        <extracomment>tables</extracomment>
        <translation>eigene</translation>
    </message>
    <message>
        <source>Custom lpi</source>
        <extracomment>tables</extracomment>
        <translation>Eigener LPI-Wert</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut off the empty rows and columns around each frame.</source>
        <translation>Schneidet die leeren Zeilen und Spalten um jeden Frame ab.</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>D&amp;unkel</translation>
    </message>
    <message>
        <source>Dahlia</source>
        <translation>Dahlie</translation>
    </message>
    <message>
        <source>Damping</source>
        <extracomment>tables</extracomment>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Damping of the swinging fur: 0 never stops, 1 stops without overshooting.</source>
        <extracomment>tables</extracomment>
        <translation>Dämpfung des schwingenden Fells: 0 hört nie auf, 1 kommt ohne Überschwingen zur Ruhe.</translation>
    </message>
    <message>
        <source>Dandelion</source>
        <translation>Pusteblume</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Darkening of the side of the coat that faces away from the room's light: 0 lights all sides alike.</source>
        <extracomment>tables</extracomment>
        <translation>Abdunklung der Seite des Fells, die dem Licht des Raums abgewandt ist: 0 beleuchtet alle Seiten gleich.</translation>
    </message>
    <message>
        <source>Darkness between the roots: 0 is not darkened, high darkens strands all the way up.</source>
        <extracomment>tables</extracomment>
        <translation>Dunkelheit zwischen den Wurzeln: 0 dunkelt nicht ab, hohe Werte bis ganz nach oben.</translation>
    </message>
    <message>
        <source>Dawn</source>
        <translation>Morgengrauen</translation>
    </message>
    <message>
        <source>De&amp;lete preset</source>
        <translation>Preset &amp;löschen</translation>
    </message>
    <message>
        <source>Decay</source>
        <extracomment>tables</extracomment>
        <translation>Abklingen</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Definitionen</translation>
    </message>
    <message>
        <source>deflate</source>
        <translation>deflate</translation>
    </message>
    <message>
        <source>Degrees clockwise about the center.</source>
        <translation>Grad im Uhrzeigersinn um die Mitte.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete sheet</source>
        <translation>Folie löschen</translation>
    </message>
    <message>
        <source>Delete the study %1</source>
        <translation>Die Studie %1 löschen</translation>
    </message>
    <message>
        <source>Deletes all nine bookmarks.</source>
        <translation>Löscht alle neun Lesezeichen.</translation>
    </message>
    <message>
        <source>Deletes the node with everything in it.</source>
        <translation>Löscht den Knoten mit allem, was er enthält.</translation>
    </message>
    <message>
        <source>Deletes the selected preset; undo brings it back.</source>
        <translation>Löscht das gewählte Preset; rückgängig machen bringt es zurück.</translation>
    </message>
    <message>
        <source>Deletes this sheet of your own from the list; the numbers below stay.</source>
        <translation>Löscht diese eigene Folie aus der Liste; die Zahlen darunter bleiben.</translation>
    </message>
    <message>
        <source>Density</source>
        <extracomment>tables</extracomment>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Density falloff</source>
        <extracomment>tables</extracomment>
        <translation>Dichteabfall</translation>
    </message>
    <message>
        <source>Density noise</source>
        <extracomment>tables</extracomment>
        <translation>Dichterauschen</translation>
    </message>
    <message>
        <source>Density of the clouds, as the share of light that a meter of the thickest cloud removes.</source>
        <extracomment>tables</extracomment>
        <translation>Dichte der Wolken, als Anteil des Lichts, den ein Meter der dicksten Wolke nimmt.</translation>
    </message>
    <message>
        <source>Density of the dust near the floor, as the share of light that a meter of it removes: 0 is clear air.</source>
        <extracomment>tables</extracomment>
        <translation>Dichte des Staubs in Bodennähe, als Anteil des Lichts, den ein Meter davon nimmt: 0 ist klare Luft.</translation>
    </message>
    <message>
        <source>Density of the fog at the water, as the share of light that a meter removes: 0 is clear.</source>
        <extracomment>tables</extracomment>
        <translation>Dichte des Nebels am Wasser, als Anteil des Lichts, den ein Meter nimmt: 0 ist klar.</translation>
    </message>
    <message>
        <source>Density of the haze: 0 is clear to the horizon, 1 hides it.</source>
        <extracomment>tables</extracomment>
        <translation>Dichte des Dunsts: 0 ist klar bis zum Horizont, 1 verbirgt ihn.</translation>
    </message>
    <message>
        <source>Density of the reference's black fog: light falls to 1/e where this value times the cube of the distance is 1.</source>
        <extracomment>tables</extracomment>
        <translation>Dichte des schwarzen Nebels der Referenz: Licht fällt auf 1/e, wo dieser Wert mal die dritte Potenz der Entfernung 1 ist.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>depth</source>
        <extracomment>tables</extracomment>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth between two surfaces that makes a line, in texels after removing the slope: low draws more lines.</source>
        <extracomment>tables</extracomment>
        <translation>Tiefe zwischen zwei Oberflächen, die eine Linie ergibt, in Texeln nach Abzug der Steigung: Niedrige Werte zeichnen mehr Linien.</translation>
    </message>
    <message>
        <source>Depth bits</source>
        <extracomment>tables</extracomment>
        <translation>Tiefenbits</translation>
    </message>
    <message>
        <source>Depth budget</source>
        <translation>Tiefenbudget</translation>
    </message>
    <message>
        <source>depth fetches</source>
        <translation>Tiefenzugriffe</translation>
    </message>
    <message>
        <source>Depth order</source>
        <extracomment>tables</extracomment>
        <translation>Tiefenfolge</translation>
    </message>
    <message>
        <source>derivative</source>
        <extracomment>tables</extracomment>
        <translation>Ableitung</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Diameter of the tube of the handle.</source>
        <extracomment>tables</extracomment>
        <translation>Durchmesser des Henkelrohrs.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Difference of B and A: gray where both are equal, brighter or darker where B is.</source>
        <translation>Unterschied von B und A: grau, wo beide gleich sind, heller oder dunkler, wo B es ist.</translation>
    </message>
    <message>
        <source>Difference that an eye sees when flipping between A and B: black is none, white is large.</source>
        <translation>Unterschied, den ein Auge beim Wechsel zwischen A und B sieht: schwarz keiner, weiß ein großer.</translation>
    </message>
    <message>
        <source>Difference: the first child without the others.</source>
        <translation>Differenz: das erste Kind ohne die anderen.</translation>
    </message>
    <message>
        <source>differences</source>
        <extracomment>tables</extracomment>
        <translation>Differenzen</translation>
    </message>
    <message>
        <source>Differing parameters</source>
        <translation>Verschiedene Parameter</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>diffuses the errors to neighbors</source>
        <translation>verteilt die Fehler auf Nachbarn</translation>
    </message>
    <message>
        <source>Direction</source>
        <extracomment>tables</extracomment>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction from the ice cream to the lamp.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung vom Eis zur Lampe.</translation>
    </message>
    <message>
        <source>Direction from the pit to the lamp.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung von der Grube zur Lampe.</translation>
    </message>
    <message>
        <source>Direction in which the draft blows.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung, in die der Luftzug weht.</translation>
    </message>
    <message>
        <source>Direction in which the dust scatters: 0 to all sides, positive forward with a glow towards the sun, negative backward.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung, in die der Staub streut: 0 nach allen Seiten, positive Werte nach vorn mit Leuchten zur Sonne hin, negative zurück.</translation>
    </message>
    <message>
        <source>Direction in which the light shines.</source>
        <translation>Richtung, in die das Licht scheint.</translation>
    </message>
    <message>
        <source>Direction in which the wind blows, from straight ahead: negative is to the left.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung, in die der Wind weht, von geradeaus: Negative Werte gehen nach links.</translation>
    </message>
    <message>
        <source>Direction of the lenses: upright for depth, across for flips, between them slanted.</source>
        <translation>Richtung der Linsen: aufrecht für Tiefe, quer für Wechselbilder, dazwischen schräg.</translation>
    </message>
    <message>
        <source>Direction of the lenses: vertical lenses change when you move sideways, horizontal ones when you move up or down.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung der Linsen: Senkrechte wechseln bei seitlicher Bewegung, waagerechte bei Bewegung auf und ab.</translation>
    </message>
    <message>
        <source>Direction that points up in the picture.</source>
        <translation>Richtung, die im Bild nach oben zeigt.</translation>
    </message>
    <message>
        <source>Direction to the sun of the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Richtung zur Sonne der Referenz.</translation>
    </message>
    <message>
        <source>Direction to the sun.</source>
        <translation>Richtung zur Sonne.</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Disk</source>
        <extracomment>tables</extracomment>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>Disk samples</source>
        <extracomment>tables</extracomment>
        <translation>Scheiben-Samples</translation>
    </message>
    <message>
        <source>Dismiss this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Dismisses all messages.</source>
        <translation>Schließt alle Meldungen.</translation>
    </message>
    <message>
        <source>Disorder</source>
        <extracomment>tables</extracomment>
        <translation>Unordnung</translation>
    </message>
    <message>
        <source>Dispersion</source>
        <extracomment>tables</extracomment>
        <translation>Dispersion</translation>
    </message>
    <message>
        <source>dispersion is switched off</source>
        <translation>Dispersion ist ausgeschaltet</translation>
    </message>
    <message>
        <source>Displacement limit</source>
        <extracomment>tables</extracomment>
        <translation>Auslenkungsgrenze</translation>
    </message>
    <message>
        <source>Displacement of the tips to the right, in strand lengths, when set by hand.</source>
        <extracomment>tables</extracomment>
        <translation>Auslenkung der Spitzen nach rechts, in Haarlängen, wenn sie von Hand gesetzt wird.</translation>
    </message>
    <message>
        <source>Displacement of the tips towards the entrance, in strand lengths, when set by hand.</source>
        <extracomment>tables</extracomment>
        <translation>Auslenkung der Spitzen zum Eingang hin, in Haarlängen, wenn sie von Hand gesetzt wird.</translation>
    </message>
    <message>
        <source>Displacement of the tips upwards, in strand lengths, when set by hand.</source>
        <extracomment>tables</extracomment>
        <translation>Auslenkung der Spitzen nach oben, in Haarlängen, wenn sie von Hand gesetzt wird.</translation>
    </message>
    <message>
        <source>Display</source>
        <extracomment>tables</extracomment>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>display-referred linear light, one sample at each pixel's center unless supersamples or pictures in motion are studied</source>
        <translation>lineares Licht der Anzeige, ein Sample in der Mitte jedes Pixels, sofern nicht Supersamples oder bewegte Bilder untersucht werden</translation>
    </message>
    <message>
        <source>Distance</source>
        <extracomment>tables</extracomment>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>distance</source>
        <extracomment>tables</extracomment>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance at which a ray counts as a hit of the field or the water, in pixels at that depth.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand, bei dem ein Strahl als Treffer des Felds oder Wassers gilt, in Pixeln bei dieser Tiefe.</translation>
    </message>
    <message>
        <source>Distance at which a ray counts as a hit, in half pixels at that depth: low is accurate, high saves steps.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand, bei dem ein Strahl als Treffer gilt, in halben Pixeln bei dieser Tiefe: Niedrige Werte sind genau, hohe sparen Schritte.</translation>
    </message>
    <message>
        <source>Distance attenuation</source>
        <extracomment>tables</extracomment>
        <translation>Entfernungsabfall</translation>
    </message>
    <message>
        <source>Distance between copies along x, y and z; 0 does not repeat along that axis.</source>
        <translation>Abstand der Kopien entlang x, y und z; 0 wiederholt entlang dieser Achse nicht.</translation>
    </message>
    <message>
        <source>Distance between the eyes.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand zwischen den Augen.</translation>
    </message>
    <message>
        <source>Distance between the two centers.</source>
        <translation>Abstand der beiden Mittelpunkte.</translation>
    </message>
    <message>
        <source>Distance beyond which shapes cause no ambient occlusion; the reference has no such limit.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand, ab dem Formen keine Umgebungsverdeckung bewirken; die Referenz kennt keine solche Grenze.</translation>
    </message>
    <message>
        <source>Distance by which one step of the mouse wheel approaches an exhibit.</source>
        <translation>Strecke, um die ein Schritt des Mausrads an ein Exponat heranführt.</translation>
    </message>
    <message>
        <source>Distance by which the candy floats up and down.</source>
        <extracomment>tables</extracomment>
        <translation>Strecke, um die das Bonbon auf und ab schwebt.</translation>
    </message>
    <message>
        <source>Distance by which the cross-section is first moved away from the axis.</source>
        <translation>Strecke, um die der Querschnitt zuvor von der Achse weggerückt wird.</translation>
    </message>
    <message>
        <source>Distance by which the tips hang down at rest, in strand lengths.</source>
        <extracomment>tables</extracomment>
        <translation>Strecke, um die die Spitzen in Ruhe herabhängen, in Haarlängen.</translation>
    </message>
    <message>
        <source>Distance by which the tips trail in moving air, in strand lengths per meter per second.</source>
        <extracomment>tables</extracomment>
        <translation>Strecke, um die die Spitzen in bewegter Luft nachwehen, in Haarlängen je Meter pro Sekunde.</translation>
    </message>
    <message>
        <source>Distance from a part at which a ray takes small even steps until it hits, in pixels at that depth: high makes edges uneven.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand von einem Teil, ab dem ein Strahl kleine gleiche Schritte macht, bis er trifft, in Pixeln bei dieser Tiefe: Hohe Werte machen Kanten ungleichmäßig.</translation>
    </message>
    <message>
        <source>Distance from the center to a corner.</source>
        <translation>Abstand vom Mittelpunkt zu einer Ecke.</translation>
    </message>
    <message>
        <source>Distance from the center to a side.</source>
        <translation>Abstand vom Mittelpunkt zu einer Seite.</translation>
    </message>
    <message>
        <source>Distance in the scene that will lie in the print's plane; 0 is what the camera looks at.</source>
        <translation>Entfernung in der Szene, die in der Ebene des Drucks liegen wird; 0 ist das, worauf die Kamera schaut.</translation>
    </message>
    <message>
        <source>Distance of the camera from the middle of the world; in orthographic projection, the start of the visible range.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand der Kamera von der Mitte der Welt; bei orthografischer Projektion der Beginn des sichtbaren Bereichs.</translation>
    </message>
    <message>
        <source>Distance of the eye from the print.</source>
        <translation>Abstand des Auges vom Druck.</translation>
    </message>
    <message>
        <source>Distance of the plane from the origin along the normal.</source>
        <translation>Abstand der Ebene vom Ursprung entlang der Normalen.</translation>
    </message>
    <message>
        <source>Distance of the sun outside the picture at which its rays have faded, in half picture sizes.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand der Sonne vom Bildrand, bei dem ihre Strahlen verblasst sind, in halben Bildgrößen.</translation>
    </message>
    <message>
        <source>Distance of the view from the origin of the noise: the picture stays sharp even ten thousand kilometers away.</source>
        <extracomment>tables</extracomment>
        <translation>Abstand der Ansicht vom Ursprung des Rauschens: Das Bild bleibt auch zehntausend Kilometer entfernt scharf.</translation>
    </message>
    <message>
        <source>Distribution of the shells over the length of the fur: below 1 more of them lie near the tips, above 1 near the skin.</source>
        <extracomment>tables</extracomment>
        <translation>Verteilung der Shells über die Länge des Fells: Unter 1 liegen mehr davon an den Spitzen, über 1 mehr an der Haut.</translation>
    </message>
    <message>
        <source>Dither</source>
        <extracomment>tables</extracomment>
        <translation>Dithering</translation>
    </message>
    <message>
        <source>Dither strength</source>
        <extracomment>tables</extracomment>
        <translation>Dithering-Stärke</translation>
    </message>
    <message>
        <source>Dithering method for colors between those of the palette: ordered, blue noise, or error diffusion.</source>
        <extracomment>tables</extracomment>
        <translation>Dithering-Verfahren für Farben zwischen denen der Palette: geordnet, blaues Rauschen oder Fehlerdiffusion.</translation>
    </message>
    <message>
        <source>Divider</source>
        <extracomment>tables</extracomment>
        <translation>Trennlinie</translation>
    </message>
    <message>
        <source>Document</source>
        <extracomment>tables</extracomment>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Done (%1 samples)</source>
        <translation>Fertig (%1 Samples)</translation>
    </message>
    <message>
        <source>Done (%1 samples); redrawing only the moving part (%2 × %3 px)</source>
        <translation>Fertig (%1 Samples); neu gezeichnet wird nur der bewegte Teil (%2 × %3 px)</translation>
    </message>
    <message>
        <source>Dots down</source>
        <translation>Punkte abwärts</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>Punkte pro Zoll</translation>
    </message>
    <message>
        <source>Dots per inch the other way. Auto: the same.</source>
        <translation>Punkte pro Zoll in der anderen Richtung. Auto: dieselben.</translation>
    </message>
    <message>
        <source>Dots per inch, vertical</source>
        <translation>Punkte pro Zoll, senkrecht</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>down upon them</source>
        <translation>von oben auf sie</translation>
    </message>
    <message>
        <source>Drag the handle to blend the settings of the four corners. Numbers, colors and angles are interpolated; choices are those of the nearest corner. One drag is one undo step; Esc cancels it. Arrow keys move the handle, with Shift finer, with Ctrl coarser.</source>
        <translation>Ziehen Sie den Griff, um die Einstellungen der vier Ecken zu mischen. Zahlen, Farben und Winkel werden interpoliert; Auswahlen sind die der nächsten Ecke. Ein Ziehen ist ein Bearbeitungsschritt; Esc bricht es ab. Pfeiltasten bewegen den Griff, mit Umschalt feiner, mit Strg gröber.</translation>
    </message>
    <message>
        <source>Drag the label or the number</source>
        <translation>Bezeichnung oder Zahl ziehen</translation>
    </message>
    <message>
        <source>Drag the label or the number; click to type, 2*pi or 30deg too.
Shift is ten times finer, Ctrl ten times coarser.</source>
        <translation>Ziehen Sie an Bezeichnung oder Zahl; klicken Sie, um zu tippen, auch 2*pi oder 30deg.
Umschalt ist zehnmal feiner, Strg zehnmal gröber.</translation>
    </message>
    <message>
        <source>Drag the line; comma, period</source>
        <translation>Die Linie ziehen; Komma, Punkt</translation>
    </message>
    <message>
        <source>Drag to the side to look from there, up and down to tilt; the arrows move by a degree, Shift by a tenth.
Home or a double click looks straight on.</source>
        <translation>Seitwärts ziehen, um von dort zu schauen, auf und ab, um zu neigen; die Pfeiltasten bewegen um ein Grad, mit Umschalt um ein Zehntel.
Pos1 oder ein Doppelklick schaut gerade darauf.</translation>
    </message>
    <message>
        <source>Drag; Ctrl and arrows</source>
        <translation>Ziehen; Strg und Pfeiltasten</translation>
    </message>
    <message>
        <source>Dragging down looks up</source>
        <translation>Nach unten ziehen schaut nach oben</translation>
    </message>
    <message>
        <source>Draw an object from all sides as a sprite sheet, with normals, depth and Aseprite's JSON beside it</source>
        <translation>Zeichnet ein Objekt von allen Seiten als Sprite-Bogen, daneben Normalen, Tiefe und Aseprites JSON</translation>
    </message>
    <message>
        <source>Draw new variations</source>
        <translation>Neue Variationen zeichnen</translation>
    </message>
    <message>
        <source>Draw order</source>
        <extracomment>tables</extracomment>
        <translation>Zeichenfolge</translation>
    </message>
    <message>
        <source>drawing frames</source>
        <translation>Bilder zeichnen</translation>
    </message>
    <message>
        <source>Drawing …</source>
        <translation>Zeichnet …</translation>
    </message>
    <message>
        <source>drawn with the last good program {1}</source>
        <translation>mit dem letzten guten Programm gezeichnet, {1}</translation>
    </message>
    <message>
        <source>drawn with {1}</source>
        <translation>gezeichnet mit {1}</translation>
    </message>
    <message>
        <source>Draws nine variations of the current settings.</source>
        <translation>Zeichnet neun Variationen der jetzigen Einstellungen.</translation>
    </message>
    <message>
        <source>Drift</source>
        <extracomment>tables</extracomment>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Drift speed</source>
        <extracomment>tables</extracomment>
        <translation>Drifttempo</translation>
    </message>
    <message>
        <source>drifts away</source>
        <extracomment>tables</extracomment>
        <translation>treibt davon</translation>
    </message>
    <message>
        <source>Drop a glTF file on the window and it stands here.</source>
        <translation>Legen Sie eine glTF-Datei auf dem Fenster ab, und sie steht hier.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Duplicates the node; the copy follows it.</source>
        <translation>Dupliziert den Knoten; die Kopie folgt ihm.</translation>
    </message>
    <message>
        <source>Dusk</source>
        <extracomment>tables</extracomment>
        <translation>Dämmerung</translation>
    </message>
    <message>
        <source>E – let it melt</source>
        <translation>E – schmelzen lassen</translation>
    </message>
    <message>
        <source>E – let it turn</source>
        <translation>E – drehen lassen</translation>
    </message>
    <message>
        <source>E – let the mobile turn</source>
        <translation>E – Mobile drehen</translation>
    </message>
    <message>
        <source>E – let time run</source>
        <translation>E – die Zeit laufen lassen</translation>
    </message>
    <message>
        <source>E – make them jump</source>
        <translation>E – springen lassen</translation>
    </message>
    <message>
        <source>E – set a lantern free</source>
        <translation>E – eine Laterne freilassen</translation>
    </message>
    <message>
        <source>E – show the other print</source>
        <translation>E – den anderen Druck zeigen</translation>
    </message>
    <message>
        <source>E&amp;xhibit</source>
        <translation>E&amp;xponat</translation>
    </message>
    <message>
        <source>each its own</source>
        <extracomment>tables</extracomment>
        <translation>jede für sich</translation>
    </message>
    <message>
        <source>ease</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Edge angle</source>
        <extracomment>tables</extracomment>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>Edge detection: adaptive, one texel wide with thresholds that follow distance and slope, or the formulas of the reference in meters.</source>
        <extracomment>tables</extracomment>
        <translation>Kantenerkennung: adaptiv, ein Texel breit mit Schwellen, die Entfernung und Steigung folgen, oder die Formeln der Referenz in Metern.</translation>
    </message>
    <message>
        <source>Edge fade</source>
        <extracomment>tables</extracomment>
        <translation>Randblende</translation>
    </message>
    <message>
        <source>Edge length of a cell. What is thinner than a cell is lost.</source>
        <translation>Kantenlänge einer Zelle. Was dünner ist als eine Zelle, geht verloren.</translation>
    </message>
    <message>
        <source>edge of the zone</source>
        <translation>Rand der Zone</translation>
    </message>
    <message>
        <source>Edges</source>
        <extracomment>tables</extracomment>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>edges</source>
        <extracomment>tables</extracomment>
        <translation>Kanten</translation>
    </message>
    <message numerus="yes">
        <source>Edit all %n together</source>
        <translation>
            <numerusform>Alle %n zusammen bearbeiten</numerusform>
            <numerusform>Alle %n zusammen bearbeiten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Edited together: a change here changes all %n groups.</source>
        <translation>
            <numerusform>Zusammen bearbeitet: Eine Änderung hier ändert %n Gruppe.</numerusform>
            <numerusform>Zusammen bearbeitet: Eine Änderung hier ändert alle %n Gruppen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Edits the tags of the selected preset, by which it can be found.</source>
        <translation>Bearbeitet die Tags des gewählten Presets, nach denen es zu finden ist.</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>EGA</source>
        <extracomment>tables</extracomment>
        <translation>EGA</translation>
    </message>
    <message>
        <source>Either order holds the same depths, so that the picture is the same.</source>
        <translation>Beide Ordnungen halten dieselben Tiefen, das Bild ist also dasselbe.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <extracomment>tables</extracomment>
        <translation>Höhenwinkel</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>Leuchten</translation>
    </message>
    <message>
        <source>Emitted light, as a multiple of the color.</source>
        <translation>Ausgestrahltes Licht, als Vielfaches der Farbe.</translation>
    </message>
    <message>
        <source>encoding a frame</source>
        <translation>das Kodieren eines Frames</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>End of the segment.</source>
        <translation>Ende der Strecke.</translation>
    </message>
    <message>
        <source>End radius</source>
        <translation>Radius am Ende</translation>
    </message>
    <message>
        <source>ending the video</source>
        <translation>das Beenden des Videos</translation>
    </message>
    <message>
        <source>Ends the comparison and shows A alone.</source>
        <translation>Beendet den Vergleich und zeigt nur noch A.</translation>
    </message>
    <message>
        <source>Enlargement of the small picture: each texel by a whole number of pixels, or to any size with borders smoothed over one pixel (sharp).</source>
        <extracomment>tables</extracomment>
        <translation>Vergrößerung des kleinen Bildes: jedes Texel auf eine ganze Zahl von Pixeln oder auf jede Größe mit über ein Pixel geglätteten Grenzen (scharf).</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Enter shows one, Space ticks it, F2 renames it, Delete deletes it.</source>
        <translation>Eingabe zeigt eine, die Leertaste hakt sie an, F2 benennt sie um, Entf löscht sie.</translation>
    </message>
    <message>
        <source>Enter, Esc</source>
        <translation>Eingabe, Esc</translation>
    </message>
    <message>
        <source>Environment</source>
        <extracomment>tables</extracomment>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Environment mapping 1</source>
        <translation>Umgebungsspiegelung 1</translation>
    </message>
    <message>
        <source>Environment mapping 2</source>
        <translation>Umgebungsspiegelung 2</translation>
    </message>
    <message>
        <source>Environment rotation</source>
        <translation>Drehung der Umgebung</translation>
    </message>
    <message>
        <source>Erosion</source>
        <extracomment>tables</extracomment>
        <translation>Erosion</translation>
    </message>
    <message>
        <source>error</source>
        <extracomment>tables</extracomment>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>error diffusion</source>
        <extracomment>tables</extracomment>
        <translation>Fehlerdiffusion</translation>
    </message>
    <message>
        <source>error diffusion is off</source>
        <translation>Fehlerdiffusion ist aus</translation>
    </message>
    <message>
        <source>Error of the pitch of the strips: 0.01 is one percent too wide.</source>
        <extracomment>tables</extracomment>
        <translation>Fehler des Streifenabstands: 0.01 ist ein Prozent zu breit.</translation>
    </message>
    <message>
        <source>Error over cost</source>
        <translation>Fehler über Kosten</translation>
    </message>
    <message>
        <source>Error scale</source>
        <extracomment>tables</extracomment>
        <translation>Fehlerskala</translation>
    </message>
    <message>
        <source>Error that is shown hottest, in degrees: low brings out small errors.</source>
        <extracomment>tables</extracomment>
        <translation>Fehler, der am heißesten gezeigt wird, in Grad: Niedrige Werte zeigen kleine Fehler.</translation>
    </message>
    <message>
        <source>Errors of bars 9 tap and vote</source>
        <translation>Fehler der Stäbe: 9 Nachbarn und Abstimmung</translation>
    </message>
    <message>
        <source>Errors over cost of several studies</source>
        <translation>Fehler über Kosten mehrerer Studien</translation>
    </message>
    <message>
        <source>evaluated</source>
        <extracomment>tables</extracomment>
        <translation>ausgewertet</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <extracomment>tables</extracomment>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Evaluation of the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Auswertung der rechten Hälfte.</translation>
    </message>
    <message>
        <source>evaluations</source>
        <extracomment>tables</extracomment>
        <translation>Auswertungen</translation>
    </message>
    <message>
        <source>evening</source>
        <translation>Abend</translation>
    </message>
    <message>
        <source>Evening clouds</source>
        <translation>Abendwolken</translation>
    </message>
    <message>
        <source>Evening dust</source>
        <translation>Abendlicher Staub</translation>
    </message>
    <message>
        <source>every shape</source>
        <extracomment>tables</extracomment>
        <translation>jede Form</translation>
    </message>
    <message>
        <source>everything exact, {1}</source>
        <translation>alles exakt, {1}</translation>
    </message>
    <message>
        <source>Everything that is set here, as JSON.</source>
        <translation>Alles, was hier eingestellt ist, als JSON.</translation>
    </message>
    <message>
        <source>Everything where smooth noise is below a level; infinite.</source>
        <translation>Alles, wo glattes Rauschen unter einer Schwelle liegt; unendlich.</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>exact in these parameters</source>
        <translation>exakt in diesen Parametern</translation>
    </message>
    <message>
        <source>exact in this parameter</source>
        <translation>exakt in diesem Parameter</translation>
    </message>
    <message>
        <source>Exaggeration</source>
        <extracomment>tables</extracomment>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>Exaggeration of heights and slopes in the pictures of heights and normals: 1 is true to scale.</source>
        <extracomment>tables</extracomment>
        <translation>Überhöhung von Höhen und Steigungen in den Bildern der Höhen und Normalen: 1 ist maßstäblich.</translation>
    </message>
    <message>
        <source>Exchanges A and B: B is shown and can be edited, and the current settings become B.</source>
        <translation>Vertauscht A und B: B wird gezeigt und lässt sich bearbeiten, und die jetzigen Einstellungen werden zu B.</translation>
    </message>
    <message>
        <source>Exclude from randomizing</source>
        <translation>Vom zufälligen Ändern ausnehmen</translation>
    </message>
    <message>
        <source>Exclusive or: everything that is in an odd number of children.</source>
        <translation>Exklusives Oder: alles, was in einer ungeraden Zahl von Kindern liegt.</translation>
    </message>
    <message>
        <source>Exhibit: %1</source>
        <translation>Exponat: %1</translation>
    </message>
    <message>
        <source>Exhibitions (*.json)</source>
        <translation>Ausstellungen (*.json)</translation>
    </message>
    <message>
        <source>Exhibits</source>
        <translation>Exponate</translation>
    </message>
    <message>
        <source>explicit Euler</source>
        <extracomment>tables</extracomment>
        <translation>explizites Euler</translation>
    </message>
    <message>
        <source>Explore</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>Exponent of the highlight: high makes it narrow.</source>
        <translation>Exponent des Glanzlichts: Hohe Werte machen es schmal.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export &amp;picture…</source>
        <translation>Bild e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Testchart exportieren</translation>
    </message>
    <message>
        <source>Export le&amp;nticular print…</source>
        <translation>&amp;Linsendruck exportieren…</translation>
    </message>
    <message>
        <source>Export lenticular print</source>
        <translation>Linsendruck exportieren</translation>
    </message>
    <message>
        <source>Export measuremen&amp;ts…</source>
        <translation>Messwer&amp;te exportieren…</translation>
    </message>
    <message>
        <source>Export mesh</source>
        <translation>Netz ausgeben</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Export picture a&amp;gain</source>
        <translation>&amp;Bild erneut exportieren</translation>
    </message>
    <message>
        <source>Export preset</source>
        <translation>Preset exportieren</translation>
    </message>
    <message>
        <source>Export spr&amp;ites…</source>
        <translation>Sp&amp;rites exportieren…</translation>
    </message>
    <message>
        <source>Export sprites</source>
        <translation>Sprites exportieren</translation>
    </message>
    <message>
        <source>Exports a print for a lenticular sheet from views of the exhibit or your own pictures, or a calibration chart.</source>
        <translation>Exportiert einen Druck für eine Linsenfolie aus Ansichten des Exponats oder eigenen Bildern, oder einen Testchart.</translation>
    </message>
    <message>
        <source>Exports a sprite sheet of an object from all sides, with one palette, normals and depth, for games.</source>
        <translation>Exportiert ein Blatt mit Sprites eines Objekts von allen Seiten, mit einer Palette, Normalen und Tiefe, für Spiele.</translation>
    </message>
    <message>
        <source>Exports the current view with the settings of the last export, under the next free name.</source>
        <translation>Exportiert die jetzige Ansicht mit den Einstellungen des letzten Exports, unter dem nächsten freien Namen.</translation>
    </message>
    <message>
        <source>Exposure</source>
        <extracomment>tables</extracomment>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Exposure, as a factor of all light; not with Phong shading.</source>
        <translation>Belichtung, als Faktor allen Lichts; nicht bei Phong-Beleuchtung.</translation>
    </message>
    <message>
        <source>Expressions: {1}. Moving a slider replaces the expression by a number.</source>
        <translation>Ausdrücke: {1}. Ein Regler ersetzt den Ausdruck durch eine Zahl.</translation>
    </message>
    <message>
        <source>Eye distance</source>
        <extracomment>tables</extracomment>
        <translation>Augenabstand</translation>
    </message>
    <message>
        <source>Eye height</source>
        <extracomment>tables</extracomment>
        <translation>Augenhöhe</translation>
    </message>
    <message>
        <source>eye {1} target {2} fov {3}</source>
        <translation>Auge {1} Ziel {2} Sichtwinkel {3}</translation>
    </message>
    <message>
        <source>Eyes</source>
        <extracomment>tables</extracomment>
        <translation>Augen</translation>
    </message>
    <message>
        <source>Eyes for which the card is drawn: off (the camera), one eye, or both as an anaglyph, the left one in red and the right one in cyan.</source>
        <extracomment>tables</extracomment>
        <translation>Augen, für die die Karte gezeichnet wird: aus (die Kamera), ein Auge oder beide als Anaglyphe, das linke in Rot und das rechte in Cyan.</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>F6, Shift+F6</source>
        <translation>F6, Umschalt+F6</translation>
    </message>
    <message>
        <source>Face</source>
        <extracomment>tables</extracomment>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>facets are averaged</source>
        <translation>Facetten werden gemittelt</translation>
    </message>
    <message>
        <source>Factor k of the reference's soft shadows: low is soft, high is sharp, 0 is hard.</source>
        <translation>Faktor k der weichen Schatten der Referenz: Niedrige Werte sind weich, hohe scharf, 0 ist hart.</translation>
    </message>
    <message>
        <source>Factor of the brightness.</source>
        <translation>Faktor der Helligkeit.</translation>
    </message>
    <message>
        <source>Factor of the fixed relaxation: 1 is none, higher takes longer steps and has to take back more of them.</source>
        <extracomment>tables</extracomment>
        <translation>Faktor der festen Relaxation: 1 ist keine, höhere Werte machen längere Schritte und müssen mehr davon zurücknehmen.</translation>
    </message>
    <message>
        <source>far away</source>
        <translation>weit weg</translation>
    </message>
    <message>
        <source>farthest={1} is before nearest={2}; give it a number from {3} to {4}</source>
        <translation>farthest={=1} liegt vor nearest={=2}; gültig ist eine Zahl von {=3} bis {=4}</translation>
    </message>
    <message>
        <source>Festival</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>few</source>
        <translation>wenige</translation>
    </message>
    <message>
        <source>FFmpeg's libraries</source>
        <translation>die Bibliotheken von FFmpeg</translation>
    </message>
    <message>
        <source>Fibers</source>
        <extracomment>tables</extracomment>
        <translation>Fasern</translation>
    </message>
    <message>
        <source>field</source>
        <extracomment>tables</extracomment>
        <translation>Feld</translation>
    </message>
    <message>
        <source>field evaluations</source>
        <translation>Feldauswertungen</translation>
    </message>
    <message>
        <source>Field evaluations of every pixel, black to white: “Heat scale” says how many are white.</source>
        <translation>Feldauswertungen jedes Pixels, von Schwarz bis Weiß: „Heatmap-Skala“ sagt, wie viele weiß sind.</translation>
    </message>
    <message>
        <source>Field noise</source>
        <extracomment>tables</extracomment>
        <translation>Feldrauschen</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Sichtwinkel</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Fillets of the cream</source>
        <extracomment>tables</extracomment>
        <translation>Rundungen des Eises</translation>
    </message>
    <message>
        <source>Fills the screen.</source>
        <translation>Füllt den Bildschirm.</translation>
    </message>
    <message>
        <source>Films (*.mp4 *.webm *.gif *.webp *.apng)</source>
        <translation>Filme (*.mp4 *.webm *.gif *.webp *.apng)</translation>
    </message>
    <message>
        <source>Filter of the shadow edges: hard, a fixed number of texels (tent), or as wide as the sun's disk makes them at that distance.</source>
        <extracomment>tables</extracomment>
        <translation>Filter der Schattenränder: hart, über eine feste Zahl von Texeln (Zelt) oder so breit, wie die Sonnenscheibe sie bei dieser Entfernung macht.</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Find a node</source>
        <translation>Knoten suchen</translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>Find a preset</source>
        <translation>Preset suchen</translation>
    </message>
    <message>
        <source>Find a shape or an operation</source>
        <translation>Eine Form oder Operation suchen</translation>
    </message>
    <message>
        <source>Find the best within the time</source>
        <translation>Das Beste innerhalb der Zeit suchen</translation>
    </message>
    <message>
        <source>Find the cheapest within the error</source>
        <translation>Das Billigste innerhalb des Fehlers suchen</translation>
    </message>
    <message>
        <source>finding a filter</source>
        <translation>das Suchen eines Filters</translation>
    </message>
    <message>
        <source>Finds and runs any command by name.</source>
        <translation>Findet jeden Befehl nach seinem Namen und führt ihn aus.</translation>
    </message>
    <message>
        <source>Finds shapes and operations by name and by what they do, such as “smooth union”.</source>
        <translation>Findet Formen und Operationen nach Namen und danach, was sie tun, etwa „smooth union“.</translation>
    </message>
    <message>
        <source>finds the parts that the sun of the small world reaches</source>
        <translation>findet, was die Sonne der kleinen Welt erreicht</translation>
    </message>
    <message>
        <source>Fine, 75 lenses an inch</source>
        <translation>Fein, 75 Linsen je Zoll</translation>
    </message>
    <message>
        <source>finished</source>
        <extracomment>tables</extracomment>
        <translation>fertig</translation>
    </message>
    <message>
        <source>Finite differences that give the normal, at 4, 4 or 6 evaluations; the first two are less accurate at creases.</source>
        <extracomment>tables</extracomment>
        <translation>Finite Differenzen, die die Normale ergeben, mit 4, 4 oder 6 Auswertungen; die ersten beiden sind an Falten ungenauer.</translation>
    </message>
    <message>
        <source>fins</source>
        <extracomment>tables</extracomment>
        <translation>Fins</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>ganz zeigen</translation>
    </message>
    <message>
        <source>Fit depth</source>
        <translation>Tiefe anpassen</translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Five o’clock</source>
        <translation>Fünf Uhr</translation>
    </message>
    <message>
        <source>Fix void</source>
        <extracomment>tables</extracomment>
        <translation>Leere korrigieren</translation>
    </message>
    <message>
        <source>fixed</source>
        <extracomment>tables</extracomment>
        <translation>fest</translation>
    </message>
    <message>
        <source>Flame height</source>
        <extracomment>tables</extracomment>
        <translation>Flammenhöhe</translation>
    </message>
    <message>
        <source>flat</source>
        <extracomment>tables</extracomment>
        <translation>flach</translation>
    </message>
    <message>
        <source>flat normal</source>
        <translation>flache Normale</translation>
    </message>
    <message>
        <source>Flat shapes</source>
        <translation>Flache Formen</translation>
    </message>
    <message>
        <source>Flattening</source>
        <extracomment>tables</extracomment>
        <translation>Abflachung</translation>
    </message>
    <message>
        <source>flavor</source>
        <translation>Sorte</translation>
    </message>
    <message>
        <source>FLI&amp;P</source>
        <translation>FLI&amp;P</translation>
    </message>
    <message>
        <source>Flicker</source>
        <translation>Flackern</translation>
    </message>
    <message>
        <source>Flicker phase</source>
        <extracomment>tables</extracomment>
        <translation>Flackerphase</translation>
    </message>
    <message>
        <source>FLIP</source>
        <translation>FLIP</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>Wechsel</translation>
    </message>
    <message>
        <source>FLIP of A and B × %1</source>
        <translation>FLIP von A und B × %1</translation>
    </message>
    <message>
        <source>Float or dock %1</source>
        <translation>%1 ablösen oder andocken</translation>
    </message>
    <message>
        <source>floor</source>
        <extracomment>tables</extracomment>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Floor mirror</source>
        <extracomment>tables</extracomment>
        <translation>Bodenspiegel</translation>
    </message>
    <message>
        <source>Foam</source>
        <extracomment>tables</extracomment>
        <translation>Schaum</translation>
    </message>
    <message>
        <source>Fog</source>
        <extracomment>tables</extracomment>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>fog</source>
        <extracomment>tables</extracomment>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Fog height</source>
        <extracomment>tables</extracomment>
        <translation>Nebelhöhe</translation>
    </message>
    <message>
        <source>Fold or unfold %1; a right click, or the dots at its end, offers more.</source>
        <translation>%1 auf- oder zuklappen; ein Rechtsklick, oder die Punkte am Ende, bieten mehr.</translation>
    </message>
    <message>
        <source>Folded</source>
        <translation>Gefaltet</translation>
    </message>
    <message>
        <source>Folder with views</source>
        <translation>Ordner mit Ansichten</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>folds of the cream, from near</source>
        <translation>Falten des Eises, aus der Nähe</translation>
    </message>
    <message>
        <source>foot</source>
        <extracomment>tables</extracomment>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Foot blend</source>
        <extracomment>tables</extracomment>
        <translation>Übergang am Fuß</translation>
    </message>
    <message>
        <source>Foot height</source>
        <extracomment>tables</extracomment>
        <translation>Fußhöhe</translation>
    </message>
    <message>
        <source>Foot radius</source>
        <extracomment>tables</extracomment>
        <translation>Fußradius</translation>
    </message>
    <message>
        <source>Foot top</source>
        <extracomment>tables</extracomment>
        <translation>Fuß oben</translation>
    </message>
    <message>
        <source>For every view, from left to right: how much of the light at its own angle comes from other views.
Optics, printed dots, and ink that spreads as far as is set.</source>
        <translation>Für jede Ansicht, von links nach rechts: wie viel des Lichts unter ihrem eigenen Winkel von anderen Ansichten kommt.
Optik, Druckpunkte und so weit verlaufende Tinte, wie eingestellt ist.</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Forward</source>
        <extracomment>tables</extracomment>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>forward</source>
        <extracomment>tables</extracomment>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>Fourth model</source>
        <extracomment>tables</extracomment>
        <translation>Modell 4</translation>
    </message>
    <message>
        <source>Fourth model across</source>
        <extracomment>tables</extracomment>
        <translation>Modell 4 quer</translation>
    </message>
    <message>
        <source>Fourth model along</source>
        <extracomment>tables</extracomment>
        <translation>Modell 4 längs</translation>
    </message>
    <message>
        <source>Fourth model plinth height</source>
        <extracomment>tables</extracomment>
        <translation>Sockelhöhe von Modell 4</translation>
    </message>
    <message>
        <source>Fourth model rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung von Modell 4</translation>
    </message>
    <message>
        <source>Fourth model size</source>
        <extracomment>tables</extracomment>
        <translation>Größe von Modell 4</translation>
    </message>
    <message>
        <source>Fourth model stand</source>
        <extracomment>tables</extracomment>
        <translation>Stand von Modell 4</translation>
    </message>
    <message>
        <source>Fourth object</source>
        <extracomment>tables</extracomment>
        <translation>Viertes Objekt</translation>
    </message>
    <message>
        <source>Fractal noise</source>
        <translation>Fraktales Rauschen</translation>
    </message>
    <message>
        <source>fractal sum</source>
        <extracomment>tables</extracomment>
        <translation>fraktale Summe</translation>
    </message>
    <message>
        <source>Frame blend</source>
        <extracomment>tables</extracomment>
        <translation>Übergang des Gestells</translation>
    </message>
    <message>
        <source>frame history</source>
        <translation>Frame-Verlauf</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Frame size</source>
        <translation>Bildgröße</translation>
    </message>
    <message>
        <source>Frame {1}, {2} x {3}, {4} samples, seed {5}</source>
        <translation>Frame {1}, {2} x {3}, {4} Samples, Startwert {5}</translation>
    </message>
    <message>
        <source>framebuffers made</source>
        <translation>angelegte Framebuffer</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>frames are independent of each other</source>
        <translation>die Frames hängen nicht voneinander ab</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Frames pro Sekunde</translation>
    </message>
    <message>
        <source>Frames per second of the animation: few look drawn by hand, many run smoothly.</source>
        <extracomment>tables</extracomment>
        <translation>Bilder pro Sekunde der Animation: Wenige wirken handgezeichnet, viele laufen flüssig.</translation>
    </message>
    <message>
        <source>Frames per second that the description tells. Auto: as long as the animation.</source>
        <translation>Bilder je Sekunde, die die Beschreibung nennt. Automatisch: so lang wie die Animation.</translation>
    </message>
    <message>
        <source>free plinth</source>
        <extracomment>tables</extracomment>
        <translation>freier Sockel</translation>
    </message>
    <message>
        <source>free some space or choose another disk</source>
        <translation>geben Sie Platz frei, oder wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>Frequency</source>
        <extracomment>tables</extracomment>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>Frequency of an octave relative to the one before: 2 doubles it.</source>
        <extracomment>tables</extracomment>
        <translation>Frequenz einer Oktave gegenüber der vorigen: 2 verdoppelt sie.</translation>
    </message>
    <message>
        <source>Frequency of the first octave, in cells per meter: low makes large blobs, high small ones.</source>
        <extracomment>tables</extracomment>
        <translation>Frequenz der ersten Oktave, in Zellen pro Meter: Niedrige Werte geben große Klumpen, hohe kleine.</translation>
    </message>
    <message>
        <source>Frequency of the melting, to the mug and back.</source>
        <extracomment>tables</extracomment>
        <translation>Frequenz des Schmelzens, zur Tasse und zurück.</translation>
    </message>
    <message>
        <source>Frequency of the noise, in cells per meter.</source>
        <translation>Frequenz des Rauschens, in Zellen pro Meter.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From a print that Vitrine made, or a .json. Dropping one here works too.</source>
        <translation>Aus einem Druck, den Vitrine erzeugt hat, oder einer .json-Datei. Sie lässt sich auch hier ablegen.</translation>
    </message>
    <message>
        <source>From A to B</source>
        <translation>Von A nach B</translation>
    </message>
    <message>
        <source>from near, later</source>
        <translation>aus der Nähe, später</translation>
    </message>
    <message>
        <source>from parent</source>
        <translation>vom Elternknoten</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>von der Seite</translation>
    </message>
    <message>
        <source>from the zone</source>
        <translation>aus der Zone</translation>
    </message>
    <message>
        <source>From where to where it reaches, and in brackets what the print holds of it, from the camera.</source>
        <translation>Von wo bis wo sie reicht, und in Klammern, was der Druck davon fasst, von der Kamera aus.</translation>
    </message>
    <message>
        <source>front</source>
        <extracomment>tables</extracomment>
        <translation>vorn</translation>
    </message>
    <message>
        <source>Front print</source>
        <extracomment>tables</extracomment>
        <translation>Vorderer Druck</translation>
    </message>
    <message>
        <source>Frozen at</source>
        <extracomment>tables</extracomment>
        <translation>Eingefroren bei</translation>
    </message>
    <message>
        <source>frozen {1} after the jump</source>
        <translation>eingefroren {1} nach dem Sprung</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Voll</translation>
    </message>
    <message>
        <source>full</source>
        <extracomment>tables</extracomment>
        <translation>voll</translation>
    </message>
    <message>
        <source>Full moon</source>
        <translation>Vollmond</translation>
    </message>
    <message>
        <source>Fur with Physics</source>
        <translation>Fell mit Physik</translation>
    </message>
    <message>
        <source>Gain</source>
        <extracomment>tables</extracomment>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Gain of the differences</source>
        <translation>Verstärkung der Unterschiede</translation>
    </message>
    <message>
        <source>Game Boy</source>
        <extracomment>tables</extracomment>
        <translation>Game Boy</translation>
    </message>
    <message>
        <source>Gamepads cannot be read: {1}.</source>
        <translation>Gamepads können nicht gelesen werden: {1}.</translation>
    </message>
    <message>
        <source>Gathered in screen space</source>
        <translation>Im Bildraum gesammelt</translation>
    </message>
    <message>
        <source>Gathering of strands into tufts towards their tips: 0 is freshly brushed, high looks wet.</source>
        <extracomment>tables</extracomment>
        <translation>Wie sehr sich Haare zu den Spitzen hin zu Büscheln sammeln: 0 ist frisch gebürstet, hohe Werte wirken nass.</translation>
    </message>
    <message>
        <source>GGX</source>
        <extracomment>tables</extracomment>
        <translation>GGX</translation>
    </message>
    <message>
        <source>Ghosts</source>
        <translation>Geisterbilder</translation>
    </message>
    <message>
        <source>give a kind and two values, such as {1}:0.1:0.9, then its options.</source>
        <translation>geben Sie eine Art und zwei Werte an, etwa {=1}:0.1:0.9, danach ihre Optionen.</translation>
    </message>
    <message>
        <source>give depth, normal or evaluations; correct it there.</source>
        <translation>geben Sie depth, normal oder evaluations an; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>glass</source>
        <extracomment>tables</extracomment>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Glass color</source>
        <extracomment>tables</extracomment>
        <translation>Glasfarbe</translation>
    </message>
    <message>
        <source>glass scatters nothing of the room's light</source>
        <translation>Glas streut nichts vom Licht des Raums</translation>
    </message>
    <message>
        <source>glass shows what is behind it</source>
        <translation>Glas zeigt, was hinter ihm liegt</translation>
    </message>
    <message>
        <source>glass stands in the sun</source>
        <translation>Glas steht in der Sonne</translation>
    </message>
    <message>
        <source>Glazed in sea green</source>
        <translation>Meergrün glasiert</translation>
    </message>
    <message>
        <source>Glide to that bookmark</source>
        <translation>Zu diesem Lesezeichen gleiten</translation>
    </message>
    <message>
        <source>Gloss along the strands: 0 is wool, high is silk.</source>
        <extracomment>tables</extracomment>
        <translation>Glanz entlang der Haare: 0 ist Wolle, hohe Werte sind Seide.</translation>
    </message>
    <message>
        <source>Gloss samples</source>
        <extracomment>tables</extracomment>
        <translation>Glanz-Samples</translation>
    </message>
    <message>
        <source>Go to &amp;entrance</source>
        <translation>Zum &amp;Eingang</translation>
    </message>
    <message>
        <source>Go to bookmark %1</source>
        <translation>Zu Lesezeichen %1</translation>
    </message>
    <message>
        <source>Goes to the next step of the lesson.</source>
        <translation>Geht zum nächsten Schritt der Lektion.</translation>
    </message>
    <message>
        <source>Goes to the previous step of the lesson.</source>
        <translation>Geht zum vorigen Schritt der Lektion.</translation>
    </message>
    <message>
        <source>Goes to the tab that has these parameters.</source>
        <translation>Wechselt zum Reiter, der diese Parameter hat.</translation>
    </message>
    <message>
        <source>Goes to the view of this bookmark; if it is not set, sets it to the current view.</source>
        <translation>Gleitet zur Ansicht dieses Lesezeichens; ist es nicht gesetzt, wird es auf die jetzige Ansicht gesetzt.</translation>
    </message>
    <message>
        <source>Going to %1 …</source>
        <translation>Auf dem Weg zu: %1 …</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>Gold</translation>
    </message>
    <message>
        <source>Golden hour</source>
        <translation>Goldene Stunde</translation>
    </message>
    <message>
        <source>golden hour</source>
        <extracomment>tables</extracomment>
        <translation>goldene Stunde</translation>
    </message>
    <message>
        <source>gone around</source>
        <translation>herumgegangen</translation>
    </message>
    <message>
        <source>GPU timer query</source>
        <translation>GPU-Timer-Abfrage</translation>
    </message>
    <message>
        <source>Gradient</source>
        <extracomment>tables</extracomment>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>gradient</source>
        <extracomment>tables</extracomment>
        <translation>Gradient</translation>
    </message>
    <message>
        <source>Gradient of three colors from the ground up.</source>
        <translation>Verlauf aus drei Farben vom Boden aufwärts.</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>Gras</translation>
    </message>
    <message>
        <source>Gravity</source>
        <extracomment>tables</extracomment>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Ground</source>
        <extracomment>tables</extracomment>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Ground color</source>
        <extracomment>tables</extracomment>
        <translation>Bodenfarbe</translation>
    </message>
    <message>
        <source>Growing</source>
        <extracomment>tables</extracomment>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Growth</source>
        <extracomment>tables</extracomment>
        <translation>Wachstum</translation>
    </message>
    <message>
        <source>Growth rate</source>
        <extracomment>tables</extracomment>
        <translation>Wachstumsrate</translation>
    </message>
    <message>
        <source>Guard</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>guard</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Gustiness</source>
        <extracomment>tables</extracomment>
        <translation>Böigkeit</translation>
    </message>
    <message>
        <source>half</source>
        <extracomment>tables</extracomment>
        <translation>halb</translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation>Halber Winkel</translation>
    </message>
    <message>
        <source>Half the depth of the candy.</source>
        <extracomment>tables</extracomment>
        <translation>Halbe Tiefe des Bonbons.</translation>
    </message>
    <message>
        <source>Half the height of the candy.</source>
        <extracomment>tables</extracomment>
        <translation>Halbe Höhe des Bonbons.</translation>
    </message>
    <message>
        <source>Half the width of the candy.</source>
        <extracomment>tables</extracomment>
        <translation>Halbe Breite des Bonbons.</translation>
    </message>
    <message>
        <source>Half x</source>
        <translation>Halbes x</translation>
    </message>
    <message>
        <source>Half y</source>
        <translation>Halbes y</translation>
    </message>
    <message>
        <source>Half z</source>
        <translation>Halbes z</translation>
    </message>
    <message>
        <source>hall</source>
        <extracomment>tables</extracomment>
        <translation>Halle</translation>
    </message>
    <message>
        <source>Hall glow</source>
        <extracomment>tables</extracomment>
        <translation>Schein in der Halle</translation>
    </message>
    <message>
        <source>Halving the error</source>
        <translation>Den Fehler zu halbieren</translation>
    </message>
    <message>
        <source>Hand rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung von Hand</translation>
    </message>
    <message>
        <source>Hand x</source>
        <extracomment>tables</extracomment>
        <translation>x von Hand</translation>
    </message>
    <message>
        <source>Hand y</source>
        <extracomment>tables</extracomment>
        <translation>y von Hand</translation>
    </message>
    <message>
        <source>Hand z</source>
        <extracomment>tables</extracomment>
        <translation>z von Hand</translation>
    </message>
    <message>
        <source>Handheld of 1989</source>
        <translation>Handkonsole von 1989</translation>
    </message>
    <message>
        <source>Handle radius</source>
        <extracomment>tables</extracomment>
        <translation>Henkelradius</translation>
    </message>
    <message>
        <source>Handle thickness</source>
        <extracomment>tables</extracomment>
        <translation>Henkeldicke</translation>
    </message>
    <message>
        <source>Handles in the picture; %1 while the picture has the focus.</source>
        <translation>Griffe im Bild; %1, während das Bild den Fokus hat.</translation>
    </message>
    <message>
        <source>Handles of the selected shape</source>
        <translation>Griffe der gewählten Form</translation>
    </message>
    <message>
        <source>Hangings</source>
        <extracomment>tables</extracomment>
        <translation>Gehänge</translation>
    </message>
    <message>
        <source>hard</source>
        <extracomment>tables</extracomment>
        <translation>hart</translation>
    </message>
    <message>
        <source>Haze</source>
        <extracomment>tables</extracomment>
        <translation>Dunst</translation>
    </message>
    <message>
        <source>Heat map</source>
        <extracomment>tables</extracomment>
        <translation>Heatmap</translation>
    </message>
    <message>
        <source>Heat scale</source>
        <extracomment>tables</extracomment>
        <translation>Heatmap-Skala</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height along y.</source>
        <translation>Höhe entlang y.</translation>
    </message>
    <message>
        <source>Height from end to end.</source>
        <translation>Höhe von Ende zu Ende.</translation>
    </message>
    <message>
        <source>Height of a cone.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe eines Kegels.</translation>
    </message>
    <message>
        <source>Height of the camera above the horizon, as an angle: negative looks up from below.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Kamera über dem Horizont, als Winkel: Negative Werte blicken von unten hinauf.</translation>
    </message>
    <message>
        <source>Height of the candy above the foot of the wafer.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des Bonbons über dem Fuß der Waffel.</translation>
    </message>
    <message>
        <source>Height of the center of the upper sphere.</source>
        <translation>Höhe des Mittelpunkts der oberen Kugel.</translation>
    </message>
    <message>
        <source>Height of the collar, the second frustum.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des Kragens, des zweiten Kegelstumpfs.</translation>
    </message>
    <message>
        <source>Height of the cones' bases above the rim of the bowl.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Grundflächen der Kegel über dem Rand der Schale.</translation>
    </message>
    <message>
        <source>Height of the cutting plane.</source>
        <translation>Höhe der Schnittebene.</translation>
    </message>
    <message>
        <source>Height of the five waves, relative to the reference: 0 is flat water.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der fünf Wellen, gegenüber der Referenz: 0 ist glattes Wasser.</translation>
    </message>
    <message>
        <source>Height of the flame above the base.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Flamme über dem Boden.</translation>
    </message>
    <message>
        <source>Height of the foot, the frustum on which the wafer stands.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des Fußes, des Kegelstumpfs, auf dem die Waffel steht.</translation>
    </message>
    <message>
        <source>Height of the lower ring.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des unteren Rings.</translation>
    </message>
    <message>
        <source>Height of the middle of the frame above the base of the clouds: between 0 and 1400 m it is inside them.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Rahmenmitte über der Unterseite der Wolken: Zwischen 0 und 1400 m liegt sie mitten darin.</translation>
    </message>
    <message>
        <source>Height of the middle of the frame above the calm water.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Rahmenmitte über dem ruhigen Wasser.</translation>
    </message>
    <message>
        <source>Height of the moon above the horizon.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des Mondes über dem Horizont.</translation>
    </message>
    <message>
        <source>Height of the mug, from its foot to its lip.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Tasse, vom Fuß bis zum Rand.</translation>
    </message>
    <message>
        <source>Height of the object's own plinth.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des eigenen Sockels des Objekts.</translation>
    </message>
    <message>
        <source>Height of the rim.</source>
        <translation>Höhe des Rands.</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon: low makes long shadows.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Sonne über dem Horizont: Niedrige Werte geben lange Schatten.</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon: low reaches far into the hall, high lights the window's foot.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der Sonne über dem Horizont: Niedrige Werte reichen weit in die Halle, hohe beleuchten den Fuß des Fensters.</translation>
    </message>
    <message>
        <source>Height of the tip.</source>
        <translation>Höhe der Spitze.</translation>
    </message>
    <message>
        <source>Height of the upper edge of the paper.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des oberen Papierrands.</translation>
    </message>
    <message>
        <source>Height of the view at the middle of the world: low zooms in, high zooms out.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des Ausschnitts in der Mitte der Welt: Niedrige Werte zoomen hinein, hohe heraus.</translation>
    </message>
    <message>
        <source>Height of the work's own sun above the horizon.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe der eigenen Sonne des Werks über dem Horizont.</translation>
    </message>
    <message>
        <source>Height over which the fog thins out.</source>
        <extracomment>tables</extracomment>
        <translation>Höhe, über die der Nebel dünner wird.</translation>
    </message>
    <message>
        <source>heights</source>
        <extracomment>tables</extracomment>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>heights or normals are shown instead of the picture</source>
        <translation>statt des Bildes werden Höhen oder Normalen gezeigt</translation>
    </message>
    <message>
        <source>held-out view {1}</source>
        <translation>zurückgehaltene Ansicht {1}</translation>
    </message>
    <message>
        <source>heldAt={1}: give a number of seconds.</source>
        <translation>heldAt={=1}: Geben Sie eine Zahl von Sekunden an.</translation>
    </message>
    <message>
        <source>hemisphere</source>
        <extracomment>tables</extracomment>
        <translation>Halbkugel</translation>
    </message>
    <message>
        <source>here is a zero byte, which no text has; remove it</source>
        <translation>hier steht ein Nullbyte, das kein Text hat; entfernen Sie es</translation>
    </message>
    <message>
        <source>here is a zero byte, which no text has; remove it.</source>
        <translation>hier steht ein Nullbyte, das in keinem Text vorkommt; entfernen Sie es.</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 ausblenden</translation>
    </message>
    <message>
        <source>Hide &amp;panels</source>
        <translation>Bedienfelder &amp;ausblenden</translation>
    </message>
    <message>
        <source>Hides all panels and bars; only the picture is left.</source>
        <translation>Blendet alle Bedienfelder und Leisten aus; nur das Bild bleibt.</translation>
    </message>
    <message>
        <source>Hides or shows all panels and bars.</source>
        <translation>Blendet alle Bedienfelder und Leisten aus oder ein.</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Highlight</source>
        <extracomment>tables</extracomment>
        <translation>Glanzlicht</translation>
    </message>
    <message>
        <source>Highlight color</source>
        <extracomment>tables</extracomment>
        <translation>Glanzlichtfarbe</translation>
    </message>
    <message>
        <source>Highlight strength</source>
        <extracomment>tables</extracomment>
        <translation>Glanzlichtstärke</translation>
    </message>
    <message>
        <source>highlights</source>
        <extracomment>tables</extracomment>
        <translation>Glanzlichter</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>History frames</source>
        <extracomment>tables</extracomment>
        <translation>Verlaufs-Frames</translation>
    </message>
    <message>
        <source>Hit tolerance</source>
        <extracomment>tables</extracomment>
        <translation>Treffertoleranz</translation>
    </message>
    <message>
        <source>Hit tolerance of the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Treffertoleranz der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Ruhezeit</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>%1 anhalten</translation>
    </message>
    <message>
        <source>holds text that is not UTF-8; retype it.</source>
        <translation>enthält Text, der kein UTF-8 ist; geben Sie ihn neu ein.</translation>
    </message>
    <message>
        <source>Hole radius</source>
        <translation>Lochradius</translation>
    </message>
    <message>
        <source>Home computer of 1982</source>
        <translation>Heimcomputer von 1982</translation>
    </message>
    <message>
        <source>Horizon</source>
        <extracomment>tables</extracomment>
        <translation>Horizont</translation>
    </message>
    <message>
        <source>Horizon color</source>
        <extracomment>tables</extracomment>
        <translation>Horizontfarbe</translation>
    </message>
    <message>
        <source>horizontal</source>
        <extracomment>tables</extracomment>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>Horizontal angle of the camera around the middle of the world.</source>
        <extracomment>tables</extracomment>
        <translation>Horizontaler Winkel der Kamera um die Mitte der Welt.</translation>
    </message>
    <message>
        <source>Horizontal direction of the moon, seen through the frame: negative is to the left.</source>
        <extracomment>tables</extracomment>
        <translation>Horizontale Richtung des Mondes, durch den Rahmen gesehen: Negative Werte liegen links.</translation>
    </message>
    <message>
        <source>Horizontal direction of the sun, seen from the camera: negative is to the left.</source>
        <extracomment>tables</extracomment>
        <translation>Horizontale Richtung der Sonne, von der Kamera aus: Negative Werte liegen links.</translation>
    </message>
    <message>
        <source>Horizontal direction of the sun, seen through the window: negative is to the left.</source>
        <extracomment>tables</extracomment>
        <translation>Horizontale Richtung der Sonne, durch das Fenster gesehen: Negative Werte liegen links.</translation>
    </message>
    <message>
        <source>Horizontal direction of the work's own sun, seen through the frame: negative is to the left.</source>
        <extracomment>tables</extracomment>
        <translation>Horizontale Richtung der eigenen Sonne des Werks, durch den Rahmen gesehen: Negative Werte liegen links.</translation>
    </message>
    <message>
        <source>hour</source>
        <translation>Stunde</translation>
    </message>
    <message>
        <source>Hour of a day at the equinox: sunlight comes through the window from three o'clock, and the sun sets at six.</source>
        <extracomment>tables</extracomment>
        <translation>Stunde eines Tages der Tagundnachtgleiche: Sonnenlicht fällt ab drei Uhr durch das Fenster, um sechs geht die Sonne unter.</translation>
    </message>
    <message>
        <source>How far apart the cameras of rendered views stand: 0 is flat, 1 true to scale for the viewing distance, above 1 deeper than life.</source>
        <translation>Wie weit die Kameras gerenderter Ansichten auseinander stehen: 0 ist flach, 1 maßstabsgetreu für den Betrachtungsabstand, über 1 tiefer als in Wirklichkeit.</translation>
    </message>
    <message>
        <source>How far the scene may reach before and behind the print, together, without doubled contours.</source>
        <translation>Wie weit die Szene vor und hinter dem Druck zusammen reichen darf, ohne doppelte Konturen.</translation>
    </message>
    <message>
        <source>How it works</source>
        <translation>So funktioniert es</translation>
    </message>
    <message>
        <source>How many views can be told apart.</source>
        <translation>Wie viele Ansichten sich unterscheiden lassen.</translation>
    </message>
    <message>
        <source>How many views to render, or to take from the files, spread evenly.</source>
        <translation>Wie viele Ansichten gerendert oder gleichmäßig aus den Dateien genommen werden.</translation>
    </message>
    <message>
        <source>How the other studies stand to the first</source>
        <translation>Wie die anderen Studien zur ersten stehen</translation>
    </message>
    <message>
        <source>https://www.aseprite.org/docs/cli/#data (written by Vitrine)</source>
        <translation>https://www.aseprite.org/docs/cli/#data (geschrieben von Vitrine)</translation>
    </message>
    <message>
        <source>Hue %1 degrees, saturation %2 %, brightness %3 %.</source>
        <translation>Farbton %1 Grad, Sättigung %2 %, Helligkeit %3 %.</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>ICC-Profil</translation>
    </message>
    <message>
        <source>Ice cream</source>
        <extracomment>tables</extracomment>
        <translation>Eis</translation>
    </message>
    <message>
        <source>Icon of Vitrine</source>
        <translation>Symbol von Vitrine</translation>
    </message>
    <message>
        <source>Import preset</source>
        <translation>Preset importieren</translation>
    </message>
    <message>
        <source>improved</source>
        <extracomment>tables</extracomment>
        <translation>verbessert</translation>
    </message>
    <message>
        <source>improved shadow</source>
        <extracomment>tables</extracomment>
        <translation>besserer Schatten</translation>
    </message>
    <message>
        <source>In dialogs and menus</source>
        <translation>In Dialogen und Menüs</translation>
    </message>
    <message>
        <source>In mid-air</source>
        <translation>Mitten in der Luft</translation>
    </message>
    <message>
        <source>In number fields</source>
        <translation>In Zahlenfeldern</translation>
    </message>
    <message>
        <source>In perspective</source>
        <translation>In Perspektive</translation>
    </message>
    <message>
        <source>in perspective</source>
        <translation>in Perspektive</translation>
    </message>
    <message>
        <source>in place</source>
        <translation>auf der Stelle</translation>
    </message>
    <message>
        <source>In preparation</source>
        <translation>In Vorbereitung</translation>
    </message>
    <message>
        <source>In presets: %1</source>
        <translation>In Presets: %1</translation>
    </message>
    <message>
        <source>In reverse order the depth of rendered views is inside out.</source>
        <translation>In umgekehrter Reihenfolge kehrt sich die Tiefe gerenderter Ansichten um.</translation>
    </message>
    <message>
        <source>In storage: shown alone</source>
        <translation>Im Depot: wird allein gezeigt</translation>
    </message>
    <message>
        <source>In the museum</source>
        <translation>Im Museum</translation>
    </message>
    <message>
        <source>In the reference, {1} is at {2}.</source>
        <translation>In der Referenz steht {1} auf {2}.</translation>
    </message>
    <message>
        <source>in the step above</source>
        <translation>im Schritt darüber</translation>
    </message>
    <message>
        <source>in the text below this heading {1}</source>
        <translation>im Text unter dieser Überschrift {1}</translation>
    </message>
    <message>
        <source>In the tree</source>
        <translation>Im Baum</translation>
    </message>
    <message>
        <source>in view</source>
        <translation>im Blick</translation>
    </message>
    <message>
        <source>in view: {1}</source>
        <translation>im Blick: {1}</translation>
    </message>
    <message>
        <source>indices must be unsigned integers</source>
        <translation>Indizes müssen vorzeichenlose ganze Zahlen sein</translation>
    </message>
    <message>
        <source>Inertia</source>
        <extracomment>tables</extracomment>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>inf</source>
        <translation>unendlich</translation>
    </message>
    <message>
        <source>Initial value: %1</source>
        <translation>Ausgangswert: %1</translation>
    </message>
    <message>
        <source>initially %1</source>
        <translation>anfangs %1</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinte</translation>
    </message>
    <message>
        <source>Ink spread</source>
        <extracomment>tables</extracomment>
        <translation>Tintenverlauf</translation>
    </message>
    <message>
        <source>inner first</source>
        <extracomment>tables</extracomment>
        <translation>innere zuerst</translation>
    </message>
    <message>
        <source>Inradius</source>
        <translation>Inkreisradius</translation>
    </message>
    <message>
        <source>inside view</source>
        <translation>Innenansicht</translation>
    </message>
    <message>
        <source>instances and includes are more than {1} deep in one another; write some of them out</source>
        <translation>Instanzen und Einbindungen liegen mehr als {1} tief ineinander; schreiben Sie einige davon aus</translation>
    </message>
    <message>
        <source>integer</source>
        <extracomment>tables</extracomment>
        <translation>ganzzahlig</translation>
    </message>
    <message>
        <source>Integration method of the springs: explicit Euler gains energy, semi-implicit Euler fails at long time steps, the closed form is exact.</source>
        <extracomment>tables</extracomment>
        <translation>Integrationsverfahren der Federn: Explizites Euler gewinnt Energie, semi-implizites versagt bei langen Zeitschritten, die geschlossene Form ist exakt.</translation>
    </message>
    <message>
        <source>Intended max angle</source>
        <extracomment>tables</extracomment>
        <translation>Vorgesehener Winkel</translation>
    </message>
    <message>
        <source>Interlacing</source>
        <translation>Verschachtelung</translation>
    </message>
    <message>
        <source>Internal error: %1. The command was not executed; everything else continues.</source>
        <translation>Interner Fehler: %1. Der Befehl wurde nicht ausgeführt; alles andere läuft weiter.</translation>
    </message>
    <message>
        <source>Interpolation of the rotation from root to tip: the matrix mix shortens strands, nlerp turns unevenly, slerp is exact.</source>
        <extracomment>tables</extracomment>
        <translation>Interpolation der Drehung von der Wurzel zur Spitze: Die Matrixmischung verkürzt Haare, nlerp dreht ungleichmäßig, slerp ist exakt.</translation>
    </message>
    <message>
        <source>Intersection: everything that all children share.</source>
        <translation>Schnitt: alles, was allen Kindern gemeinsam ist.</translation>
    </message>
    <message>
        <source>Intersections</source>
        <translation>Schnittmengen</translation>
    </message>
    <message>
        <source>into the mug, along its wall</source>
        <translation>in die Tasse, an ihrer Wand entlang</translation>
    </message>
    <message>
        <source>Into the window</source>
        <translation>Ins Fenster hinein</translation>
    </message>
    <message>
        <source>into the window</source>
        <translation>ins Fenster</translation>
    </message>
    <message>
        <source>Irregularity</source>
        <extracomment>tables</extracomment>
        <translation>Unregelmäßigkeit</translation>
    </message>
    <message>
        <source>is damaged ({1})</source>
        <translation>ist beschädigt ({=1})</translation>
    </message>
    <message>
        <source>is not a finite number; reset it.</source>
        <translation>ist keine endliche Zahl; setzen Sie sie zurück.</translation>
    </message>
    <message>
        <source>isle</source>
        <extracomment>tables</extracomment>
        <translation>Insel</translation>
    </message>
    <message>
        <source>Isotropy</source>
        <translation>Isotropie</translation>
    </message>
    <message>
        <source>it became shorter while it was read; try again.</source>
        <translation>die Datei wurde kürzer, während sie gelesen wurde; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>it cannot be opened</source>
        <translation>sie lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>it claims to unpack to {1} times its size, more than the format can pack</source>
        <translation>es will sich zum {1}-fachen seiner Größe entpacken, mehr, als das Format packen kann</translation>
    </message>
    <message>
        <source>it contains unknown preferences</source>
        <translation>sie enthält unbekannte Einstellungen</translation>
    </message>
    <message>
        <source>It has &quot;{1}&quot;, which its child would lose; take that out first.</source>
        <translation>Sie hat „{=1}“, was ihr Kind verlieren würde; nehmen Sie das zuerst heraus.</translation>
    </message>
    <message>
        <source>it has no channels</source>
        <translation>es hat keine Kanäle</translation>
    </message>
    <message>
        <source>it has no color: there are neither channels R, G and B nor Y, only {1}</source>
        <translation>es hat keine Farbe: Es gibt weder Kanäle R, G und B noch Y, nur {1}</translation>
    </message>
    <message>
        <source>it has no pixels</source>
        <translation>es hat keine Pixel</translation>
    </message>
    <message>
        <source>it has one of the characters \ $ ~ : or a control character</source>
        <translation>er enthält eines der Zeichen \ $ ~ : oder ein Steuerzeichen</translation>
    </message>
    <message>
        <source>it has two JSON chunks</source>
        <translation>die Datei hat zwei JSON-Blöcke</translation>
    </message>
    <message>
        <source>it has {1} bytes, more than the {2} allowed here; choose a smaller file.</source>
        <translation>die Datei hat {1} Bytes, mehr als die hier erlaubten {2}; wählen Sie eine kleinere Datei.</translation>
    </message>
    <message>
        <source>it has {1} channels</source>
        <translation>es hat {1} Kanäle</translation>
    </message>
    <message>
        <source>it has {1}, more than the {2} allowed</source>
        <translation>es hat {1}, mehr als die erlaubten {2}</translation>
    </message>
    <message>
        <source>it is a deep picture; flatten it first</source>
        <translation>es ist ein tiefes Bild (deep); reduzieren Sie es zuerst auf eine Ebene</translation>
    </message>
    <message>
        <source>it is a folder; choose a file name.</source>
        <translation>das ist ein Ordner; wählen Sie einen Dateinamen.</translation>
    </message>
    <message>
        <source>it is a symbolic link, or a chain of them; name the file itself.</source>
        <translation>das ist ein symbolischer Link, oder eine Kette davon; nennen Sie die Datei selbst.</translation>
    </message>
    <message>
        <source>it is a volume</source>
        <translation>es ist ein Volumen</translation>
    </message>
    <message>
        <source>it is an absolute path</source>
        <translation>das ist ein absoluter Pfad</translation>
    </message>
    <message>
        <source>it is an animation; save its pictures one by one</source>
        <translation>es ist eine Animation; speichern Sie ihre Bilder einzeln</translation>
    </message>
    <message>
        <source>it is broken (its header tells another size)</source>
        <translation>es ist beschädigt (sein Kopf nennt eine andere Größe)</translation>
    </message>
    <message>
        <source>it is broken ({1})</source>
        <translation>es ist beschädigt ({=1})</translation>
    </message>
    <message>
        <source>it is broken: it ends within its header</source>
        <translation>es ist beschädigt: Es endet in seinem Kopf</translation>
    </message>
    <message>
        <source>it is broken: its attribute &quot;{1}&quot; claims {2} bytes, and the file has {3} left</source>
        <translation>es ist beschädigt: Sein Attribut „{1}“ gibt {2} Byte an, und die Datei hat nur noch {3}</translation>
    </message>
    <message>
        <source>it is broken: its attribute &quot;{1}&quot; does not have the size of its type</source>
        <translation>es ist beschädigt: Sein Attribut „{1}“ hat nicht die Größe seines Typs</translation>
    </message>
    <message>
        <source>it is broken: its header claims more than the file holds</source>
        <translation>es ist beschädigt: Sein Kopf verspricht mehr, als die Datei enthält</translation>
    </message>
    <message>
        <source>it is cut short: the file ends within the picture</source>
        <translation>es ist abgeschnitten: Die Datei endet mitten im Bild</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>ohne Inhalt</translation>
    </message>
    <message>
        <source>it is larger than FFmpeg reads</source>
        <translation>es ist größer, als FFmpeg liest</translation>
    </message>
    <message>
        <source>It is left out until it can be read.</source>
        <translation>Sie wird weggelassen, bis sie gelesen werden kann.</translation>
    </message>
    <message>
        <source>It is left out: {1}</source>
        <translation>Es wird weggelassen: {1}</translation>
    </message>
    <message>
        <source>it is longer than 4096 bytes</source>
        <translation>er ist länger als 4096 Bytes</translation>
    </message>
    <message>
        <source>it is made of light</source>
        <translation>es besteht aus Licht</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>sie ist keine Datei</translation>
    </message>
    <message>
        <source>it is no text</source>
        <translation>sie ist kein Text</translation>
    </message>
    <message>
        <source>it is not a regular file; choose a file.</source>
        <translation>das ist keine gewöhnliche Datei; wählen Sie eine Datei.</translation>
    </message>
    <message>
        <source>it is not a regular file; choose another name.</source>
        <translation>das ist keine gewöhnliche Datei; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>it is not a {1} picture</source>
        <translation>es ist kein Bild in {1}</translation>
    </message>
    <message>
        <source>it is not in the format of preferences</source>
        <translation>sie hat nicht das Format der Einstellungen</translation>
    </message>
    <message>
        <source>it is not of glTF version 2</source>
        <translation>die Datei ist nicht von glTF-Version 2</translation>
    </message>
    <message>
        <source>it is not placed in the hall</source>
        <translation>es steht nicht in der Halle</translation>
    </message>
    <message>
        <source>it is packed in pieces of more than 512 MiB; save it in smaller ones</source>
        <translation>es ist in Stücken von mehr als 512 MiB gepackt; speichern Sie es in kleineren</translation>
    </message>
    <message>
        <source>it is shown alone in the light of the reference</source>
        <translation>es wird allein im Licht der Referenz gezeigt</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>sie ist zu groß</translation>
    </message>
    <message>
        <source>it is too short for a GLB container</source>
        <translation>die Datei ist zu kurz für einen GLB-Container</translation>
    </message>
    <message>
        <source>it is {1} pixels wide across its lenses, and {2} is the most.</source>
        <translation>er ist quer zu seinen Linsen {1} Pixel breit, und {2} sind das Höchste.</translation>
    </message>
    <message>
        <source>it is {1}, and only PNG and JPEG are allowed here</source>
        <translation>es ist {1}, und hier sind nur PNG und JPEG erlaubt</translation>
    </message>
    <message>
        <source>it leaves its folder with &quot;..&quot;</source>
        <translation>er verlässt seinen Ordner mit „..“</translation>
    </message>
    <message>
        <source>it may be seen through window and oculus</source>
        <translation>er könnte durch Fenster und Oculus zu sehen sein</translation>
    </message>
    <message>
        <source>it names a folder</source>
        <translation>das nennt einen Ordner</translation>
    </message>
    <message>
        <source>it names no file; choose a file name.</source>
        <translation>das nennt keine Datei; wählen Sie einen Dateinamen.</translation>
    </message>
    <message>
        <source>it needs {1} bytes and the disk has {2} left; free some space or choose another disk.</source>
        <translation>nötig sind {1} Bytes, und auf dem Datenträger sind {2} frei; geben Sie Platz frei, oder wählen Sie einen anderen Datenträger.</translation>
    </message>
    <message>
        <source>it saves every ray the way to the object</source>
        <translation>es spart jedem Strahl den Weg zum Objekt</translation>
    </message>
    <message>
        <source>it says that it is to be shown turned or mirrored, so that its lenses lie elsewhere; use the file as it was written</source>
        <translation>sie sagt, dass sie gedreht oder gespiegelt zu zeigen ist, sodass ihre Linsen anderswo liegen; verwenden Sie die Datei, wie sie geschrieben wurde</translation>
    </message>
    <message>
        <source>it stands in the hall</source>
        <translation>es steht in der Halle</translation>
    </message>
    <message>
        <source>it stands in the hall's light</source>
        <translation>es steht im Licht der Halle</translation>
    </message>
    <message>
        <source>it throws no shadow</source>
        <translation>es wirft keinen Schatten</translation>
    </message>
    <message>
        <source>it was not prepared</source>
        <translation>es wurde nicht vorbereitet</translation>
    </message>
    <message>
        <source>it was not prepared for this view</source>
        <translation>es wurde für diese Ansicht nicht vorbereitet</translation>
    </message>
    <message>
        <source>its BIN chunk</source>
        <translation>dem BIN-Block</translation>
    </message>
    <message>
        <source>its BIN chunk is not the second one</source>
        <translation>der BIN-Block ist nicht der zweite</translation>
    </message>
    <message>
        <source>its block must be an object: {...}.</source>
        <translation>ihr Block muss ein Objekt sein: {...}.</translation>
    </message>
    <message>
        <source>its color channels lie too far apart among its others; save them alone</source>
        <translation>seine Farbkanäle liegen zwischen den anderen zu weit auseinander; speichern Sie sie allein</translation>
    </message>
    <message>
        <source>Its color profile cannot be used and is ignored; its pixels are taken as sRGB.</source>
        <translation>Sein Farbprofil ist nicht zu gebrauchen und wird nicht beachtet; seine Pixel gelten als sRGB.</translation>
    </message>
    <message>
        <source>Its color profile does not fit its pixels and is ignored; they are taken as sRGB.</source>
        <translation>Sein Farbprofil passt nicht zu seinen Pixeln und wird nicht beachtet; sie gelten als sRGB.</translation>
    </message>
    <message>
        <source>its colors are coded as XYZE, and only RGBE is read; convert it, for example with Radiance's ra_xyze -r</source>
        <translation>seine Farben sind als XYZE kodiert, und nur RGBE wird gelesen; rechnen Sie es um, zum Beispiel mit ra_xyze -r von Radiance</translation>
    </message>
    <message>
        <source>its colors are stored as luminance and chroma (Y, RY, BY), which is not read; save it with the channels R, G and B</source>
        <translation>seine Farben sind als Helligkeit und Farbdifferenz (Y, RY, BY) gespeichert, was nicht gelesen wird; speichern Sie es mit den Kanälen R, G und B</translation>
    </message>
    <message>
        <source>its content is {1} although its name ends in &quot;{2}&quot;</source>
        <translation>der Inhalt ist {1}, obwohl der Name auf „{=2}“ endet</translation>
    </message>
    <message>
        <source>its count differs from that of other attributes</source>
        <translation>die Anzahl weicht von der anderer Attribute ab</translation>
    </message>
    <message>
        <source>its elements reach beyond the buffer view, which has {1} bytes</source>
        <translation>die Elemente reichen über die Buffer-View hinaus, die {1} Bytes hat</translation>
    </message>
    <message>
        <source>its elevations do not rise</source>
        <translation>ihre Höhenwinkel steigen nicht</translation>
    </message>
    <message>
        <source>Its error</source>
        <translation>Ihr Fehler</translation>
    </message>
    <message>
        <source>its file is not read</source>
        <translation>seine Datei ist nicht gelesen</translation>
    </message>
    <message>
        <source>its first chunk is not JSON</source>
        <translation>der erste Block ist nicht JSON</translation>
    </message>
    <message>
        <source>its folder cannot be locked ({1}).</source>
        <translation>Sein Ordner lässt sich nicht sperren ({1}).</translation>
    </message>
    <message>
        <source>its folder cannot be opened ({1}); make it, or choose another.</source>
        <translation>Sein Ordner lässt sich nicht öffnen ({1}); legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>its half is out of view</source>
        <translation>seine Hälfte ist außer Sicht</translation>
    </message>
    <message>
        <source>its header</source>
        <translation>dem Kopf</translation>
    </message>
    <message>
        <source>its header gives another length than the file has</source>
        <translation>der Kopf nennt eine andere Länge, als die Datei hat</translation>
    </message>
    <message>
        <source>its JSON</source>
        <translation>dem JSON</translation>
    </message>
    <message>
        <source>its JSON is not an object</source>
        <translation>das JSON ist kein Objekt</translation>
    </message>
    <message>
        <source>its keys and values do not agree; export the file again.</source>
        <translation>die Schlüssel und Werte passen nicht zusammen; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>its lenses are slanted, and the card's are upright or level; look at it with vitrine proof.</source>
        <translation>seine Linsen sind schräg, und die der Karte stehen aufrecht oder liegen; sehen Sie ihn mit vitrine proof an.</translation>
    </message>
    <message>
        <source>its lenses are {1} mm deep, and the thickness is only {2} mm</source>
        <translation>ihre Linsen sind {1} mm tief, und die Dicke beträgt nur {2} mm</translation>
    </message>
    <message>
        <source>its numbers have not rested for a while</source>
        <translation>ihre Zahlen haben eine Weile nicht geruht</translation>
    </message>
    <message>
        <source>Its operation would be left without what it works on; delete or unwrap that one.</source>
        <translation>Seine Operation bliebe ohne das, worauf sie wirkt; löschen Sie jene, oder packen Sie aus.</translation>
    </message>
    <message>
        <source>Its outline is nearly good, its reflections break at every edge: “Tessellation” says how many there are.</source>
        <translation>Sein Umriss ist fast gut, seine Spiegelungen brechen an jeder Kante: „Tessellierung“ sagt, wie viele es gibt.</translation>
    </message>
    <message>
        <source>its output is not used</source>
        <translation>seine Ausgabe wird nicht gebraucht</translation>
    </message>
    <message>
        <source>its own</source>
        <extracomment>tables</extracomment>
        <translation>eigene</translation>
    </message>
    <message>
        <source>Its pictures were not kept.</source>
        <translation>Ihre Bilder wurden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>its pixels are of a kind that is not read ({1})</source>
        <translation>seine Pixel sind von einer Art, die nicht gelesen wird ({1})</translation>
    </message>
    <message>
        <source>its pixels are of an unknown kind</source>
        <translation>die Pixel sind von unbekannter Art</translation>
    </message>
    <message>
        <source>its pixels do not lie in rows; save it as a plain TIFF</source>
        <translation>die Pixel liegen nicht in Zeilen; speichern Sie es als einfaches TIFF</translation>
    </message>
    <message>
        <source>its place overflows; export the file again.</source>
        <translation>die Lage läuft über; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>its prints cannot be shown</source>
        <translation>ihre Drucke können nicht gezeigt werden</translation>
    </message>
    <message>
        <source>its radius raised to {1} mm, which its lenses need</source>
        <translation>ihr Radius auf {1} mm erhöht, den ihre Linsen brauchen</translation>
    </message>
    <message>
        <source>its rows are packed into strips that are too large</source>
        <translation>die Zeilen sind in zu große Streifen gepackt</translation>
    </message>
    <message>
        <source>its rows come in several passes; save it without interlacing</source>
        <translation>die Zeilen kommen in mehreren Durchgängen; speichern Sie es ohne Interlacing</translation>
    </message>
    <message>
        <source>its samples are neither of 8 nor of 16 bits</source>
        <translation>die Samples haben weder 8 noch 16 Bits</translation>
    </message>
    <message>
        <source>Its samples were converted to 32-bit float.</source>
        <translation>Die Samples wurden in 32-Bit-Gleitkommazahlen umgewandelt.</translation>
    </message>
    <message>
        <source>its second chunk</source>
        <translation>dem zweiten Block</translation>
    </message>
    <message>
        <source>its settings are {1} bytes and a JPEG holds {2}; choose PNG</source>
        <translation>seine Einstellungen haben {=1} Bytes, und ein JPEG fasst {=2}; wählen Sie PNG</translation>
    </message>
    <message>
        <source>its size is no multiple of its tiles' size, which the OpenImageIO library that Vitrine uses cannot read safely (the file is good); save it by scanlines</source>
        <translation>seine Größe ist kein Vielfaches der Größe seiner Kacheln, was die Bibliothek OpenImageIO, die Vitrine verwendet, nicht sicher lesen kann (die Datei ist gut); speichern Sie es zeilenweise</translation>
    </message>
    <message>
        <source>its stride is smaller than an element</source>
        <translation>die Schrittweite ist kleiner als ein Element</translation>
    </message>
    <message>
        <source>its symbolic links lead in a circle; name the file itself.</source>
        <translation>die symbolischen Links führen im Kreis; nennen Sie die Datei selbst.</translation>
    </message>
    <message>
        <source>its times do not rise; export the file again.</source>
        <translation>die Zeiten steigen nicht; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>its type or component type is none of glTF's</source>
        <translation>Typ oder Komponententyp ist keiner von glTF</translation>
    </message>
    <message>
        <source>its type or component type is none of glTF's; export the file again.</source>
        <translation>Typ oder Komponententyp ist keiner von glTF; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>its windows lie too far from the origin</source>
        <translation>seine Fenster liegen zu weit vom Ursprung</translation>
    </message>
    <message>
        <source>its {1} does not fit the file</source>
        <translation>nicht in die Datei passt: {1}</translation>
    </message>
    <message>
        <source>Jitter</source>
        <extracomment>tables</extracomment>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>joined</source>
        <extracomment>tables</extracomment>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>JSON chunk</source>
        <translation>JSON-Block</translation>
    </message>
    <message>
        <source>JSON has no binary values</source>
        <translation>JSON kennt keine Binärwerte</translation>
    </message>
    <message>
        <source>Jump</source>
        <extracomment>tables</extracomment>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>jumped by themselves {1} ago</source>
        <translation>von selbst gesprungen vor {1}</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Meine behalten</translation>
    </message>
    <message>
        <source>Keep the current settings here</source>
        <translation>Die jetzigen Einstellungen hier merken</translation>
    </message>
    <message>
        <source>keeping its permissions</source>
        <translation>das Beibehalten der Rechte</translation>
    </message>
    <message>
        <source>Keeps a copy of a study from elsewhere: the study.json of “vitrine study”.</source>
        <translation>Bewahrt eine Kopie einer Studie von anderswo auf: die study.json von „vitrine study“.</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Aufbewahrt</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>beibehalten</translation>
    </message>
    <message>
        <source>Kept settings</source>
        <translation>Gemerkte Einstellungen</translation>
    </message>
    <message>
        <source>Kept studies</source>
        <translation>Aufbewahrte Studien</translation>
    </message>
    <message>
        <source>Kept: %1.</source>
        <translation>Aufbewahrt: %1.</translation>
    </message>
    <message>
        <source>key of {1}</source>
        <translation>Schlüssel von {1}</translation>
    </message>
    <message>
        <source>Keyboard, mouse and gamepad</source>
        <translation>Tastatur, Maus und Gamepad</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Kind</source>
        <extracomment>tables</extracomment>
        <translation>Art</translation>
    </message>
    <message>
        <source>kind of motion</source>
        <translation>Art von Bewegung</translation>
    </message>
    <message>
        <source>kind of node</source>
        <translation>Knotenart</translation>
    </message>
    <message>
        <source>Kind of noise: values at the cell corners, gradients there, gradients on a simplex lattice, or the distance to the nearest of scattered points (cellular).</source>
        <extracomment>tables</extracomment>
        <translation>Art des Rauschens: Werte an den Ecken der Zellen, Gradienten dort, Gradienten auf einem Simplex-Gitter oder die Distanz zum nächsten verstreuter Punkte (zellular).</translation>
    </message>
    <message>
        <source>Lacunarity</source>
        <extracomment>tables</extracomment>
        <translation>Lacunarity</translation>
    </message>
    <message>
        <source>Lamp</source>
        <extracomment>tables</extracomment>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Lamp color</source>
        <extracomment>tables</extracomment>
        <translation>Lampenfarbe</translation>
    </message>
    <message>
        <source>Lamp direction</source>
        <extracomment>tables</extracomment>
        <translation>Lampenrichtung</translation>
    </message>
    <message>
        <source>Lamp size</source>
        <extracomment>tables</extracomment>
        <translation>Lampengröße</translation>
    </message>
    <message>
        <source>Lamp strength</source>
        <extracomment>tables</extracomment>
        <translation>Lampenstärke</translation>
    </message>
    <message>
        <source>Lamp temperature</source>
        <extracomment>tables</extracomment>
        <translation>Lampentemperatur</translation>
    </message>
    <message>
        <source>Lamps</source>
        <extracomment>tables</extracomment>
        <translation>Lampen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Language of the window, from its next start. Files and the numbers in them do not change.</source>
        <translation>Sprache des Fensters, ab dem nächsten Start. Dateien und die Zahlen darin ändern sich nicht.</translation>
    </message>
    <message>
        <source>Lanterns</source>
        <extracomment>tables</extracomment>
        <translation>Laternen</translation>
    </message>
    <message>
        <source>Largest angle by which the tips lag behind the rotation of their body; the reference allows 30 degrees.</source>
        <extracomment>tables</extracomment>
        <translation>Größter Winkel, um den die Spitzen hinter der Drehung ihres Körpers zurückbleiben; die Referenz erlaubt 30 Grad.</translation>
    </message>
    <message>
        <source>Largest displacement of the tips, in strand lengths.</source>
        <extracomment>tables</extracomment>
        <translation>Größte Auslenkung der Spitzen, in Haarlängen.</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>largest error of linear light</source>
        <translation>größter Fehler des linearen Lichts</translation>
    </message>
    <message>
        <source>Largest length of the rays when the sun is far outside the picture, in picture heights.</source>
        <extracomment>tables</extracomment>
        <translation>Größte Länge der Strahlen, wenn die Sonne weit außerhalb des Bildes steht, in Bildhöhen.</translation>
    </message>
    <message>
        <source>Largest number of cells of the strand lattice that a ray tests between two shells where it grazes the coat.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Zellen des Haargitters, die ein Strahl zwischen zwei Shells prüft, wo er das Fell streift.</translation>
    </message>
    <message>
        <source>Largest number of reflections along a ray.</source>
        <translation>Höchstzahl der Spiegelungen entlang eines Strahls.</translation>
    </message>
    <message>
        <source>Largest number of reflections along a ray: 0 shows none. A scene may limit it further.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Spiegelungen entlang eines Strahls: 0 zeigt keine. Eine Szene kann sie weiter begrenzen.</translation>
    </message>
    <message>
        <source>Largest number of samples per pixel in the window when nothing moves: few finish sooner and leave rougher edges. Exports, recordings and prints have their own.</source>
        <translation>Höchstzahl der Samples pro Pixel im Fenster, wenn sich nichts bewegt: Wenige sind eher fertig und lassen Kanten rauer. Exporte, Aufnahmen und Drucke haben eigene Zahlen.</translation>
    </message>
    <message>
        <source>Largest number of steps in which a ray finds the water.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Schritte, in denen ein Strahl das Wasser findet.</translation>
    </message>
    <message>
        <source>Largest number of steps of a ray in one lantern; with a fixed number of cells, in all lanterns together.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Schritte eines Strahls in einer Laterne; bei fester Zellenzahl in allen Laternen zusammen.</translation>
    </message>
    <message>
        <source>Largest number of steps of a ray to find the field, or the sea as in the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Schritte eines Strahls, um das Feld oder das Meer wie in der Referenz zu finden.</translation>
    </message>
    <message>
        <source>Largest number of steps of a ray; beyond it, the ray ends at the best candidate so far.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Schritte eines Strahls; danach endet er am bis dahin besten Kandidaten.</translation>
    </message>
    <message>
        <source>Largest number of steps of a ray; towards a light at most 128.</source>
        <extracomment>tables</extracomment>
        <translation>Höchstzahl der Schritte eines Strahls; zu einem Licht hin höchstens 128.</translation>
    </message>
    <message>
        <source>Late sun</source>
        <translation>Späte Sonne</translation>
    </message>
    <message>
        <source>later, from the side</source>
        <translation>später, von der Seite</translation>
    </message>
    <message>
        <source>Layer blend</source>
        <extracomment>tables</extracomment>
        <translation>Schichtübergang</translation>
    </message>
    <message>
        <source>Leave it</source>
        <translation>Dort lassen</translation>
    </message>
    <message>
        <source>Leave the exhibit and walk on</source>
        <translation>Das Exponat verlassen und weitergehen</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>Lektion verlassen</translation>
    </message>
    <message>
        <source>Leaves the lesson and restores your settings.</source>
        <translation>Verlässt die Lektion und stellt Ihre Einstellungen wieder her.</translation>
    </message>
    <message>
        <source>Ledger</source>
        <translation>Frame-Protokoll</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>Left eye</source>
        <translation>Linkes Auge</translation>
    </message>
    <message>
        <source>Left of the line the setting, right of it the reference; arrows move the line, Enter opens a large view.</source>
        <translation>Links der Linie die Einstellung, rechts die Referenz; Pfeiltasten bewegen die Linie, Eingabe öffnet eine große Ansicht.</translation>
    </message>
    <message>
        <source>Left of the line the setting, right of it the reference; arrows move the line.</source>
        <translation>Links der Linie die Einstellung, rechts die Referenz; Pfeiltasten bewegen die Linie.</translation>
    </message>
    <message>
        <source>Left of the line: the setting. Right of it: the reference. Beside it: where they differ.
A double click, or Enter, opens them large, to zoom into.</source>
        <translation>Links der Linie: die Einstellung. Rechts davon: die Referenz. Daneben: wo sie sich unterscheiden.
Ein Doppelklick oder die Eingabetaste öffnet sie groß, um hineinzuzoomen.</translation>
    </message>
    <message>
        <source>Left out of the folder {1}, because these files are no {2} pictures: {3}.</source>
        <translation>Aus dem Ordner {1} weggelassen, weil es keine Bilder in {2} sind: {3}.</translation>
    </message>
    <message>
        <source>Left stick</source>
        <translation>Linker Stick</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length along x.</source>
        <translation>Länge entlang x.</translation>
    </message>
    <message>
        <source>Length along y.</source>
        <translation>Länge entlang y.</translation>
    </message>
    <message>
        <source>Length along z.</source>
        <translation>Länge entlang z.</translation>
    </message>
    <message>
        <source>Length of a sprinkle.</source>
        <extracomment>tables</extracomment>
        <translation>Länge eines Streusels.</translation>
    </message>
    <message>
        <source>Length of an edge of the base.</source>
        <translation>Länge einer Kante der Grundfläche.</translation>
    </message>
    <message>
        <source>Length of the diagonal along x.</source>
        <translation>Länge der Diagonale entlang x.</translation>
    </message>
    <message>
        <source>Length of the diagonal along z.</source>
        <translation>Länge der Diagonale entlang z.</translation>
    </message>
    <message>
        <source>Length of the first edge.</source>
        <translation>Länge der ersten Kante.</translation>
    </message>
    <message>
        <source>Length of the longest strands of this coat: 0 leaves the bare skin.</source>
        <extracomment>tables</extracomment>
        <translation>Länge der längsten Haare dieses Fells: 0 lässt die nackte Haut.</translation>
    </message>
    <message>
        <source>Length of the object's largest side.</source>
        <extracomment>tables</extracomment>
        <translation>Länge der größten Seite des Objekts.</translation>
    </message>
    <message>
        <source>Length of the ribs relative to their width.</source>
        <extracomment>tables</extracomment>
        <translation>Länge der Rippen im Verhältnis zu ihrer Breite.</translation>
    </message>
    <message>
        <source>Length of the second edge.</source>
        <translation>Länge der zweiten Kante.</translation>
    </message>
    <message>
        <source>Length of the shortest strands as a share of the longest: at 0 they have no length, at 1 all are equally long, like a lawn.</source>
        <extracomment>tables</extracomment>
        <translation>Länge der kürzesten Haare als Anteil der längsten: Bei 0 haben sie keine, bei 1 sind alle gleich lang wie bei einem Rasen.</translation>
    </message>
    <message>
        <source>Length of the straight parts.</source>
        <translation>Länge der geraden Teile.</translation>
    </message>
    <message>
        <source>Lengths inserted along x, y and z.</source>
        <translation>Eingefügte Längen entlang x, y und z.</translation>
    </message>
    <message>
        <source>Lengths of the edges along x, y and z.</source>
        <translation>Längen der Kanten entlang x, y und z.</translation>
    </message>
    <message>
        <source>Lengths of the outer sides along x, y and z.</source>
        <translation>Längen der Außenseiten entlang x, y und z.</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>Lens gloss</source>
        <extracomment>tables</extracomment>
        <translation>Linsenglanz</translation>
    </message>
    <message>
        <source>Lens sheet</source>
        <translation>Linsenfolie</translation>
    </message>
    <message>
        <source>LENSES ACROSS - FEED: TOP / SIDE</source>
        <translation>LENSES ACROSS - FEED: TOP / SIDE</translation>
    </message>
    <message>
        <source>lenses of {1} mm need a radius above {2} mm, and it is {3} mm; focused on its back the sheet is then at least {4} mm thick</source>
        <translation>Linsen von {1} mm brauchen einen Radius über {2} mm, und er ist {3} mm; auf ihre Rückseite fokussiert, ist die Folie dann mindestens {4} mm dick</translation>
    </message>
    <message>
        <source>Lenses per inch</source>
        <translation>Linsen pro Zoll</translation>
    </message>
    <message>
        <source>Lenses per inch as a pitch chart showed it with this printer. Auto: not measured, that of the sheet.</source>
        <translation>Linsen pro Zoll, wie ein Pitch-Testchart sie mit diesem Drucker zeigte. Auto: nicht gemessen, die der Folie.</translation>
    </message>
    <message>
        <source>Lenses per inch of the strips, with the resolution as the file stores it.</source>
        <translation>Linsen pro Zoll der Streifen, bei der Auflösung, wie die Datei sie speichert.</translation>
    </message>
    <message>
        <source>Lenses per inch read from a pitch chart at that distance. Auto: not measured, it follows from the distance.</source>
        <translation>Linsen pro Zoll, aus diesem Abstand an einem Pitch-Testchart abgelesen. Auto: nicht gemessen, sie folgt aus dem Abstand.</translation>
    </message>
    <message>
        <source>Lenses per inch that the sheet is sold as.</source>
        <translation>Linsen pro Zoll, als die die Folie verkauft wird.</translation>
    </message>
    <message>
        <source>LENSES UP - FEED: TOP / SIDE</source>
        <translation>LENSES UP - FEED: TOP / SIDE</translation>
    </message>
    <message>
        <source>Lenticular Card</source>
        <translation>Linsenkarte</translation>
    </message>
    <message>
        <source>lenticular raster</source>
        <translation>Linsenraster</translation>
    </message>
    <message>
        <source>Lenticular sheet: lenses per inch and viewing zone, 30 degrees (3d) or 50 (flip). Custom uses the parameters below.</source>
        <extracomment>tables</extracomment>
        <translation>Linsenfolie: Linsen pro Zoll und Sichtzone, 30 Grad (3d) oder 50 (flip). „Eigene“ nimmt die Parameter darunter.</translation>
    </message>
    <message>
        <source>lenticular views</source>
        <translation>Linsenansichten</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Lesson step %1</source>
        <translation>Lektion, Schritt %1</translation>
    </message>
    <message>
        <source>Lesson: %1</source>
        <translation>Lektion: %1</translation>
    </message>
    <message>
        <source>Lessons (*.md)</source>
        <translation>Lektionen (*.md)</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <extracomment>tables</extracomment>
        <translation>Detailstufe</translation>
    </message>
    <message>
        <source>libvitrine_gamepad.so belongs to another version of Vitrine; build both together.</source>
        <translation>libvitrine_gamepad.so gehört zu einer anderen Version von Vitrine; bauen Sie beide zusammen.</translation>
    </message>
    <message>
        <source>Light</source>
        <extracomment>tables</extracomment>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Light</source>
        <comment>theme</comment>
        <translation>Hell</translation>
    </message>
    <message>
        <source>light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>light alone</source>
        <extracomment>tables</extracomment>
        <translation>nur das Licht</translation>
    </message>
    <message>
        <source>Light and gloss</source>
        <extracomment>tables</extracomment>
        <translation>Licht und Glanz</translation>
    </message>
    <message>
        <source>Light cells</source>
        <extracomment>tables</extracomment>
        <translation>Lichtzellen</translation>
    </message>
    <message>
        <source>Light from one direction.</source>
        <translation>Licht aus einer Richtung.</translation>
    </message>
    <message>
        <source>light on the strands that were found</source>
        <translation>Licht auf den gefundenen Haaren</translation>
    </message>
    <message>
        <source>Light reflected by white at the camera's target, as linear values; with Phong shading, at any distance.</source>
        <translation>Licht, das Weiß am Ziel der Kamera zurückwirft, in linearen Werten; bei Phong-Beleuchtung in jeder Entfernung.</translation>
    </message>
    <message>
        <source>Light reflected by white that faces the sun, as linear values.</source>
        <translation>Licht, das Weiß zurückwirft, das der Sonne zugewandt ist, in linearen Werten.</translation>
    </message>
    <message>
        <source>Light size</source>
        <extracomment>tables</extracomment>
        <translation>Lichtgröße</translation>
    </message>
    <message>
        <source>Light steps</source>
        <extracomment>tables</extracomment>
        <translation>Lichtschritte</translation>
    </message>
    <message>
        <source>light, lines and palette</source>
        <translation>Licht, Linien und Palette</translation>
    </message>
    <message>
        <source>Lighting</source>
        <extracomment>tables</extracomment>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Lighting model: physically based, with translucent paper and Fresnel reflections, or that of the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Beleuchtungsmodell: physikalisch basiert, mit durchscheinendem Papier und Fresnel-Spiegelungen, oder das der Referenz.</translation>
    </message>
    <message>
        <source>Lighting of the ice cream: by the hall around it, or by the sun, ambient light and fog of the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Beleuchtung des Eises: durch die Halle ringsum oder durch Sonne, Umgebungslicht und Nebel der Referenz.</translation>
    </message>
    <message>
        <source>linear</source>
        <extracomment>tables</extracomment>
        <translation>linear</translation>
    </message>
    <message>
        <source>linear light is handed out as it is</source>
        <translation>lineares Licht wird ausgegeben, wie es ist</translation>
    </message>
    <message>
        <source>linear light is requested</source>
        <translation>lineares Licht ist verlangt</translation>
    </message>
    <message>
        <source>Lines</source>
        <extracomment>tables</extracomment>
        <translation>Linien</translation>
    </message>
    <message>
        <source>Lines and points are not supported and were left out of mesh {1}.</source>
        <translation>Linien und Punkte werden nicht unterstützt und wurden im Netz {=1} weggelassen.</translation>
    </message>
    <message>
        <source>list --manual: there is no exhibit &quot;{1}&quot;; `vitrine list` names them.</source>
        <translation>list --manual: Kein Exponat heißt &quot;{=1}&quot;; `vitrine list` nennt alle.</translation>
    </message>
    <message>
        <source>list of primitives</source>
        <translation>Liste von Grundkörpern</translation>
    </message>
    <message>
        <source>lists have no numbers in their text</source>
        <translation>Listen haben keine Zahlen in ihrem Text</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>%1 laden</translation>
    </message>
    <message>
        <source>Load settings</source>
        <translation>Einstellungen laden</translation>
    </message>
    <message>
        <source>Load settings…</source>
        <translation>Einstellungen laden…</translation>
    </message>
    <message>
        <source>loading was canceled.</source>
        <translation>das Laden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Lobes</source>
        <extracomment>tables</extracomment>
        <translation>Wülste</translation>
    </message>
    <message>
        <source>Lock the group</source>
        <translation>Die Gruppe sperren</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Longest time in milliseconds</source>
        <translation>Längste Zeit in Millisekunden</translation>
    </message>
    <message>
        <source>Look</source>
        <extracomment>tables</extracomment>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Look around with the pointer locked</source>
        <translation>Umschauen mit gefangenem Zeiger</translation>
    </message>
    <message>
        <source>Look around, or around the exhibit</source>
        <translation>Umschauen, oder um das Exponat herum</translation>
    </message>
    <message>
        <source>Looking</source>
        <translation>Blick</translation>
    </message>
    <message>
        <source>looking through the lenses</source>
        <translation>durch die Linsen sehen</translation>
    </message>
    <message>
        <source>loop</source>
        <extracomment>tables</extracomment>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Low ring</source>
        <extracomment>tables</extracomment>
        <translation>Höhe des unteren Rings</translation>
    </message>
    <message>
        <source>Low sun</source>
        <translation>Tiefe Sonne</translation>
    </message>
    <message>
        <source>Lower blend</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Übergang</translation>
    </message>
    <message>
        <source>Lower color</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Farbe</translation>
    </message>
    <message>
        <source>Lower corner</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Rundung</translation>
    </message>
    <message>
        <source>lower cream</source>
        <extracomment>tables</extracomment>
        <translation>unteres Eis</translation>
    </message>
    <message>
        <source>Lower height</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Höhe</translation>
    </message>
    <message>
        <source>Lower layer of cream</source>
        <extracomment>tables</extracomment>
        <translation>Untere Eisschicht</translation>
    </message>
    <message>
        <source>Lower left corner</source>
        <translation>Ecke unten links</translation>
    </message>
    <message>
        <source>Lower lobes</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Wülste</translation>
    </message>
    <message>
        <source>Lower offset x</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Versatz x</translation>
    </message>
    <message>
        <source>Lower offset z</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Versatz z</translation>
    </message>
    <message>
        <source>Lower radius</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Radius</translation>
    </message>
    <message>
        <source>Lower raise</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Anheben</translation>
    </message>
    <message>
        <source>Lower right corner</source>
        <translation>Ecke unten rechts</translation>
    </message>
    <message>
        <source>Lower tilt</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Neigung</translation>
    </message>
    <message>
        <source>Lower twist</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Verdrillung</translation>
    </message>
    <message>
        <source>Lower yaw</source>
        <extracomment>tables</extracomment>
        <translation>Untere Schicht: Gieren</translation>
    </message>
    <message>
        <source>LPI in the file</source>
        <translation>LPI in der Datei</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>made unit length)</source>
        <translation>auf Länge eins gebracht)</translation>
    </message>
    <message>
        <source>Magnification</source>
        <extracomment>tables</extracomment>
        <translation>Vergrößerung</translation>
    </message>
    <message>
        <source>Major radius</source>
        <extracomment>tables</extracomment>
        <translation>Großer Radius</translation>
    </message>
    <message>
        <source>Make %1 a %2</source>
        <translation>%1 in %2 umwandeln</translation>
    </message>
    <message>
        <source>Make a closed mesh of a scene's surface, for other programs and 3D printers</source>
        <translation>Macht ein geschlossenes Netz aus der Oberfläche einer Szene, für andere Programme und 3D-Drucker</translation>
    </message>
    <message>
        <source>making the sheet</source>
        <translation>den Bogen anlegen</translation>
    </message>
    <message>
        <source>many</source>
        <translation>viele</translation>
    </message>
    <message>
        <source>March</source>
        <extracomment>tables</extracomment>
        <translation>Schrittverfahren</translation>
    </message>
    <message>
        <source>march</source>
        <extracomment>tables</extracomment>
        <translation>Raymarching</translation>
    </message>
    <message>
        <source>march steps</source>
        <translation>Raymarching-Schritte</translation>
    </message>
    <message>
        <source>Marched through the air</source>
        <translation>Durch die Luft abgeschritten</translation>
    </message>
    <message>
        <source>Margin</source>
        <extracomment>tables</extracomment>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Margin beyond the trim on every side; lenses and views go on there.</source>
        <translation>Rand über den Beschnitt hinaus an jeder Seite; Linsen und Ansichten gehen dort weiter.</translation>
    </message>
    <message>
        <source>Mask</source>
        <extracomment>tables</extracomment>
        <translation>Maske</translation>
    </message>
    <message>
        <source>mask</source>
        <extracomment>tables</extracomment>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Matches in the other tab</source>
        <translation>Treffer im anderen Reiter</translation>
    </message>
    <message>
        <source>Material</source>
        <extracomment>tables</extracomment>
        <translation>Material</translation>
    </message>
    <message>
        <source>material</source>
        <extracomment>tables</extracomment>
        <translation>Material</translation>
    </message>
    <message>
        <source>Material of the ice cream: opaque reflects, glass also refracts at every surface.</source>
        <extracomment>tables</extracomment>
        <translation>Material des Eises: Undurchsichtig spiegelt, Glas bricht außerdem an jeder Oberfläche.</translation>
    </message>
    <message>
        <source>Material of the object: opaque reflects, glass also refracts at every surface.</source>
        <extracomment>tables</extracomment>
        <translation>Material des Objekts: Undurchsichtig spiegelt, Glas bricht außerdem an jeder Oberfläche.</translation>
    </message>
    <message>
        <source>Material of the shape and of everything in it that sets no other.</source>
        <translation>Material der Form und von allem in ihr, das kein anderes setzt.</translation>
    </message>
    <message>
        <source>material without a name</source>
        <translation>Material ohne Namen</translation>
    </message>
    <message>
        <source>material {1}</source>
        <translation>Material {=1}</translation>
    </message>
    <message>
        <source>matrix mix</source>
        <extracomment>tables</extracomment>
        <translation>Matrixmischung</translation>
    </message>
    <message>
        <source>may change any pixel</source>
        <translation>kann jedes Pixel ändern</translation>
    </message>
    <message>
        <source>mean</source>
        <extracomment>tables</extracomment>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>mean angle between normals, degrees</source>
        <translation>mittlerer Winkel zwischen Normalen, Grad</translation>
    </message>
    <message>
        <source>mean FLIP</source>
        <translation>mittleres FLIP</translation>
    </message>
    <message>
        <source>Mean size</source>
        <extracomment>tables</extracomment>
        <translation>Mittelungsgröße</translation>
    </message>
    <message>
        <source>Meaning of the colors: the materials, or one color per part.</source>
        <extracomment>tables</extracomment>
        <translation>Bedeutung der Farben: die Materialien oder eine Farbe je Teil.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measure, or stop measuring</source>
        <translation>Messen, oder das Messen anhalten</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Measured per inch</source>
        <translation>Gemessen pro Zoll</translation>
    </message>
    <message>
        <source>Melting</source>
        <translation>Schmelzend</translation>
    </message>
    <message>
        <source>melting, from behind</source>
        <translation>schmelzend, von hinten</translation>
    </message>
    <message>
        <source>Memory at most</source>
        <translation>Speicher höchstens</translation>
    </message>
    <message>
        <source>memory is full</source>
        <translation>der Speicher ist voll</translation>
    </message>
    <message>
        <source>Memory that meshing may take, in megabytes. Auto: half of the machine's.</source>
        <translation>Speicher, den das Vernetzen belegen darf, in Megabyte. Automatisch: die Hälfte des Speichers der Maschine.</translation>
    </message>
    <message>
        <source>Menu of %1</source>
        <translation>Menü von %1</translation>
    </message>
    <message>
        <source>Mercury</source>
        <translation>Quecksilber</translation>
    </message>
    <message>
        <source>mesh</source>
        <extracomment>tables</extracomment>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Mesh {1} has a normal map but no texture coordinates.</source>
        <translation>Das Netz {=1} hat eine Normal-Map, aber keine Texturkoordinaten.</translation>
    </message>
    <message>
        <source>Mesh {1} has a part without positions, which was left out.</source>
        <translation>Das Netz {=1} hat einen Teil ohne Positionen, der weggelassen wurde.</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Metalness</source>
        <extracomment>tables</extracomment>
        <translation>Metallanteil</translation>
    </message>
    <message>
        <source>Method</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Method for normals in the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren für Normalen in der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Method for normals: drawn ones (true), or reconstructed from depth by fixed neighbors (3, 4), nearer ones (5), those in line with a texel (9, 9 plus), a parabola, or a vote of the texels around, which thin objects need.</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren für Normalen: gezeichnet (richtig) oder aus der Tiefe rekonstruiert durch feste Nachbarn (3, 4), nähere (5), solche in einer Linie mit dem Texel (9, 9 plus), eine Parabel oder eine Abstimmung der Texel ringsum, die dünne Objekte brauchen.</translation>
    </message>
    <message>
        <source>Method of ambient occlusion: as the shading has it, none, 5 taps along the normal, rays over the hemisphere, or cones.</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren der Umgebungsverdeckung: je nach Beleuchtung, keines, 5 Samples entlang der Normalen, Strahlen über die Halbkugel oder Kegel.</translation>
    </message>
    <message>
        <source>Method that fills the gaps between shells seen from the side: nothing, fins along the edges, more shells at oblique angles, or ray marching between the shells.</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren, das die Lücken zwischen seitlich gesehenen Shells füllt: nichts, Fins entlang der Kanten, mehr Shells bei schrägem Blick oder Raymarching zwischen den Shells.</translation>
    </message>
    <message>
        <source>Method that separates the sky from the occluders: depth, coverage (alpha), or drawing the occluders once more.</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren, das den Himmel von den Verdeckern trennt: Tiefe, Bedeckung (Alpha) oder nochmaliges Zeichnen der Verdecker.</translation>
    </message>
    <message>
        <source>Method to average along a ray: sample by sample, three passes that build on each other's results, or a running sum on a polar grid.</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren der Mittelung entlang eines Strahls: Sample für Sample, drei Passes, die auf den Ergebnissen der vorigen aufbauen, oder eine laufende Summe auf einem Polargitter.</translation>
    </message>
    <message>
        <source>Method with which shapes shade each other: as the shading has it, none, one ray (hard), three estimates of soft shadows from one ray, or many rays (area).</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren, mit dem Formen einander beschatten: je nach Beleuchtung, keines, ein Strahl (hart), drei Schätzungen weicher Schatten aus einem Strahl oder viele Strahlen (Fläche).</translation>
    </message>
    <message>
        <source>Method with which the object shades itself from the sun: none, one ray (hard), three estimates of soft shadows from one ray, or many rays (area).</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren, mit dem das Objekt sich vor der Sonne beschattet: keines, ein Strahl (hart), drei Schätzungen weicher Schatten aus einem Strahl oder viele Strahlen (Fläche).</translation>
    </message>
    <message>
        <source>Methods of normals from depth</source>
        <translation>Verfahren für Normalen aus der Tiefe</translation>
    </message>
    <message>
        <source>Milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>milliseconds</source>
        <translation>Millisekunden</translation>
    </message>
    <message>
        <source>milliseconds of a picture</source>
        <translation>Millisekunden eines Bildes</translation>
    </message>
    <message>
        <source>milliseconds of a picture, by a clock that is not trusted</source>
        <translation>Millisekunden eines Bildes, nach einer Uhr, der nicht zu trauen ist</translation>
    </message>
    <message>
        <source>Milliseconds of the same pass with settings B, in a complete frame that reuses nothing from the previous one.</source>
        <translation>Millisekunden desselben Passes mit den Einstellungen B, in einem vollständigen Frame, der nichts vom vorigen übernimmt.</translation>
    </message>
    <message>
        <source>Milliseconds that a skipped pass took when it last ran. “Run everything” measures all of them.</source>
        <translation>Millisekunden, die ein ausgelassener Pass brauchte, als er zuletzt lief. „Alles ausführen“ misst sie alle.</translation>
    </message>
    <message>
        <source>Minor radius</source>
        <extracomment>tables</extracomment>
        <translation>Kleiner Radius</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegel</translation>
    </message>
    <message>
        <source>Mirrored rays lead upwards and seldom meet the water again.</source>
        <translation>Gespiegelte Strahlen führen nach oben und treffen das Wasser selten noch einmal.</translation>
    </message>
    <message>
        <source>Mirrored repeat is not supported; textures repeat.</source>
        <translation>Gespiegelte Wiederholung wird nicht unterstützt; Texturen wiederholen sich.</translation>
    </message>
    <message>
        <source>Mobile rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Mobiles</translation>
    </message>
    <message>
        <source>Model</source>
        <extracomment>tables</extracomment>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Model across</source>
        <extracomment>tables</extracomment>
        <translation>Modell quer</translation>
    </message>
    <message>
        <source>Model along</source>
        <extracomment>tables</extracomment>
        <translation>Modell längs</translation>
    </message>
    <message>
        <source>Model of the highlights of the reference's sun: microfacets (GGX), or Blinn-Phong with the exponent 2^(10 (1 - roughness)).</source>
        <extracomment>tables</extracomment>
        <translation>Modell der Glanzlichter der Sonne der Referenz: Mikrofacetten (GGX) oder Blinn-Phong mit dem Exponenten 2^(10 (1 - Rauheit)).</translation>
    </message>
    <message>
        <source>Model plinth height</source>
        <extracomment>tables</extracomment>
        <translation>Sockelhöhe des Modells</translation>
    </message>
    <message>
        <source>Model rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Modells</translation>
    </message>
    <message>
        <source>Model size</source>
        <extracomment>tables</extracomment>
        <translation>Modellgröße</translation>
    </message>
    <message>
        <source>Model stand</source>
        <extracomment>tables</extracomment>
        <translation>Stand des Modells</translation>
    </message>
    <message>
        <source>Model that finds the strip seen at a view angle: proportional to its tangent as in the reference (linear), first-order optics (paraxial), or Snell's law at the lens (exact).</source>
        <extracomment>tables</extracomment>
        <translation>Modell, das den Streifen zu einem Blickwinkel findet: proportional zum Tangens wie in der Referenz (linear), Optik erster Ordnung (paraxial) oder das Brechungsgesetz an der Linse (exakt).</translation>
    </message>
    <message>
        <source>Moire, without a filter</source>
        <translation>Moiré, ohne Filter</translation>
    </message>
    <message>
        <source>Moment</source>
        <extracomment>tables</extracomment>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>Moon</source>
        <extracomment>tables</extracomment>
        <translation>Mond</translation>
    </message>
    <message>
        <source>Moon and sky</source>
        <extracomment>tables</extracomment>
        <translation>Mond und Himmel</translation>
    </message>
    <message>
        <source>Moon azimuth</source>
        <extracomment>tables</extracomment>
        <translation>Mondazimut</translation>
    </message>
    <message>
        <source>Moon elevation</source>
        <extracomment>tables</extracomment>
        <translation>Mondhöhe</translation>
    </message>
    <message>
        <source>Moon size</source>
        <extracomment>tables</extracomment>
        <translation>Mondgröße</translation>
    </message>
    <message>
        <source>More for kept studies</source>
        <translation>Mehr zu aufbewahrten Studien</translation>
    </message>
    <message>
        <source>More for presets</source>
        <translation>Mehr zu Presets</translation>
    </message>
    <message>
        <source>More solids</source>
        <translation>Weitere Körper</translation>
    </message>
    <message>
        <source>More variations like this one</source>
        <translation>Mehr Variationen wie diese</translation>
    </message>
    <message>
        <source>Morning</source>
        <translation>Morgen</translation>
    </message>
    <message>
        <source>morning</source>
        <translation>Morgen</translation>
    </message>
    <message>
        <source>Morph</source>
        <extracomment>tables</extracomment>
        <translation>Morph</translation>
    </message>
    <message>
        <source>Morph targets are not supported; mesh {1} keeps its first shape.</source>
        <translation>Morph-Ziele werden nicht unterstützt; das Netz {=1} behält seine erste Form.</translation>
    </message>
    <message>
        <source>Morph towards B</source>
        <translation>Überblenden nach B</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation>Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>Motion of the fur</source>
        <extracomment>tables</extracomment>
        <translation>Bewegung des Fells</translation>
    </message>
    <message>
        <source>Motion of the lanterns: on a separate wave as in the reference, or on the water under their base.</source>
        <extracomment>tables</extracomment>
        <translation>Bewegung der Laternen: auf einer eigenen Welle wie in der Referenz oder auf dem Wasser unter ihrem Boden.</translation>
    </message>
    <message>
        <source>Motion of the window. Reduced: the camera jumps instead of gliding, panels do not slide, messages do not fade, and the exhibits' clock is paused until you start it (Space in the picture) or press an exhibit's button. Walking and dragging are not affected.</source>
        <translation>Bewegung im Fenster. Reduziert: Die Kamera springt, statt zu gleiten, Bedienfelder gleiten nicht, Meldungen blenden nicht aus, und die Uhr der Exponate steht, bis Sie sie starten (Leertaste im Bild) oder den Knopf eines Exponats drücken. Gehen und Ziehen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Move %1 on</source>
        <translation>%1 weiterbewegen</translation>
    </message>
    <message>
        <source>Move between four settings</source>
        <translation>Zwischen vier Einstellungen bewegen</translation>
    </message>
    <message>
        <source>Move on</source>
        <translation>Weiterbewegen</translation>
    </message>
    <message>
        <source>Move the focus to the next or the previous panel</source>
        <translation>Den Fokus ins nächste oder vorige Bedienfeld setzen</translation>
    </message>
    <message>
        <source>Move the node: up, down, out of its parent, into the one above</source>
        <translation>Den Knoten verschieben: auf, ab, aus seinem Elternknoten, in den darüber</translation>
    </message>
    <message>
        <source>Move the wipe</source>
        <translation>Die Wischblende bewegen</translation>
    </message>
    <message>
        <source>Moves the cameras together until the print holds the whole scene.</source>
        <translation>Rückt die Kameras zusammen, bis der Druck die ganze Szene fasst.</translation>
    </message>
    <message>
        <source>Moves the focus to the filter above the parameters.</source>
        <translation>Setzt den Fokus in den Filter über den Parametern.</translation>
    </message>
    <message>
        <source>Moves the focus to the next part of the window: picture, panels, clock.</source>
        <translation>Setzt den Fokus in den nächsten Teil des Fensters: Bild, Bedienfelder, Uhr.</translation>
    </message>
    <message>
        <source>Moves the focus to the previous part of the window.</source>
        <translation>Setzt den Fokus in den vorigen Teil des Fensters.</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>MSX</source>
        <extracomment>tables</extracomment>
        <translation>MSX</translation>
    </message>
    <message>
        <source>Mug height</source>
        <extracomment>tables</extracomment>
        <translation>Tassenhöhe</translation>
    </message>
    <message>
        <source>Mug radius</source>
        <extracomment>tables</extracomment>
        <translation>Tassenradius</translation>
    </message>
    <message>
        <source>Museum</source>
        <translation>Museum</translation>
    </message>
    <message>
        <source>Name of the animation that is played. Empty: the first one of the file.</source>
        <translation>Name der Animation, die abgespielt wird. Leer: die erste der Datei.</translation>
    </message>
    <message>
        <source>Name of the sheet</source>
        <translation>Name der Folie</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächste</translation>
    </message>
    <message>
        <source>nearest of the palette</source>
        <translation>nächste der Palette</translation>
    </message>
    <message>
        <source>neither it nor its shadow is in view</source>
        <translation>weder es noch sein Schatten ist im Blick</translation>
    </message>
    <message>
        <source>NES</source>
        <extracomment>tables</extracomment>
        <translation>NES</translation>
    </message>
    <message>
        <source>New name</source>
        <translation>Neuer Name</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Neues Tastenkürzel</translation>
    </message>
    <message>
        <source>New shortcut for “%1”; its default is %2.</source>
        <translation>Neues Tastenkürzel für „%1“; üblich ist %2.</translation>
    </message>
    <message>
        <source>New shortcut for “%1”; its default is none.</source>
        <translation>Neues Tastenkürzel für „%1“; üblich ist keines.</translation>
    </message>
    <message>
        <source>Newsprint</source>
        <translation>Zeitungsdruck</translation>
    </message>
    <message>
        <source>Next ▸</source>
        <translation>Weiter ▸</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>Nacht</translation>
    </message>
    <message>
        <source>night</source>
        <translation>Nacht</translation>
    </message>
    <message>
        <source>night, water</source>
        <translation>Nacht, Wasser</translation>
    </message>
    <message>
        <source>Nine variations</source>
        <translation>Neun Variationen</translation>
    </message>
    <message>
        <source>nlerp</source>
        <extracomment>tables</extracomment>
        <translation>nlerp</translation>
    </message>
    <message>
        <source>no animation of the model is chosen</source>
        <translation>keine Animation des Modells ist gewählt</translation>
    </message>
    <message>
        <source>No beams</source>
        <translation>Keine Strahlen</translation>
    </message>
    <message>
        <source>no bounce is asked for</source>
        <translation>keine Spiegelung im Objekt ist verlangt</translation>
    </message>
    <message>
        <source>no button is in view</source>
        <translation>kein Knopf ist im Blick</translation>
    </message>
    <message>
        <source>no cloth or stand is in view</source>
        <translation>kein Tuch oder Ständer ist im Blick</translation>
    </message>
    <message>
        <source>No command matches.</source>
        <translation>Kein Befehl passt.</translation>
    </message>
    <message>
        <source>No count of work tells these settings apart.</source>
        <translation>Keine gezählte Arbeit unterscheidet diese Einstellungen.</translation>
    </message>
    <message>
        <source>no counts are requested</source>
        <translation>es werden keine Zählwerte verlangt</translation>
    </message>
    <message>
        <source>no exhibit stands here</source>
        <translation>hier steht kein Exponat</translation>
    </message>
    <message>
        <source>no exhibit throws a shadow that may be seen</source>
        <translation>kein Exponat wirft einen Schatten, der zu sehen sein könnte</translation>
    </message>
    <message>
        <source>no file is chosen for it</source>
        <translation>dafür ist keine Datei gewählt</translation>
    </message>
    <message>
        <source>No film can be recorded: there is no graphics context.</source>
        <translation>Es kann kein Film aufgenommen werden: Es gibt keinen Grafikkontext.</translation>
    </message>
    <message>
        <source>No frame has been drawn yet.</source>
        <translation>Noch wurde kein Frame gezeichnet.</translation>
    </message>
    <message>
        <source>No hair is stored anywhere: a skin drawn again and again, a little further out each time.</source>
        <translation>Nirgends ist ein Haar gespeichert: eine Haut, wieder und wieder gezeichnet, jedes Mal etwas weiter außen.</translation>
    </message>
    <message>
        <source>No handles: through &quot;{1}&quot; around it, its middle is seen nowhere. Change its numbers instead.</source>
        <translation>Keine Griffe: Durch „{=1}“ darum herum ist seine Mitte nirgends zu sehen. Ändern Sie stattdessen die Zahlen.</translation>
    </message>
    <message>
        <source>no lamp hangs here</source>
        <translation>hier hängt keine Lampe</translation>
    </message>
    <message>
        <source>no lamp shines here</source>
        <translation>hier scheint keine Lampe</translation>
    </message>
    <message>
        <source>no lamp throws shadows</source>
        <translation>keine Lampe wirft Schatten</translation>
    </message>
    <message>
        <source>no lantern is afloat</source>
        <translation>keine Laterne schwimmt</translation>
    </message>
    <message>
        <source>no light falls on the card</source>
        <translation>kein Licht fällt auf die Karte</translation>
    </message>
    <message>
        <source>no light of the scene has an area</source>
        <translation>kein Licht der Szene hat eine Fläche</translation>
    </message>
    <message>
        <source>no loads of different size were timed</source>
        <translation>keine Lasten verschiedener Größe wurden gemessen</translation>
    </message>
    <message>
        <source>no material reflects the lights</source>
        <translation>kein Material wirft das Licht der Lichter zurück</translation>
    </message>
    <message>
        <source>no mesh was made</source>
        <translation>kein Netz wurde erzeugt</translation>
    </message>
    <message>
        <source>no motion follows this frame</source>
        <translation>auf diesen Frame folgt keine Bewegung</translation>
    </message>
    <message>
        <source>No node matches.</source>
        <translation>Kein Knoten passt.</translation>
    </message>
    <message>
        <source>No OpenGL was found; OpenGL 4.5 is needed: install a graphics driver, or Mesa's software one (libgl1-mesa-dri).</source>
        <translation>Kein OpenGL wurde gefunden; nötig ist OpenGL 4.5: Installieren Sie einen Grafiktreiber, oder Mesas Software-Treiber (libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>No parameter matches &quot;%1&quot;.</source>
        <translation>Kein Parameter passt zu „%1“.</translation>
    </message>
    <message>
        <source>No picture can be made: there is no graphics context.</source>
        <translation>Es kann kein Bild gemacht werden: Es gibt keinen Grafikkontext.</translation>
    </message>
    <message>
        <source>No picture was exported yet; use “Export picture…” first.</source>
        <translation>Es wurde noch kein Bild exportiert; zuerst „Bild exportieren…“ verwenden.</translation>
    </message>
    <message>
        <source>No pixel differs.</source>
        <translation>Kein Pixel unterscheidet sich.</translation>
    </message>
    <message>
        <source>no plaque is in view</source>
        <translation>kein Schild ist im Blick</translation>
    </message>
    <message>
        <source>No point is measured yet</source>
        <translation>Noch ist kein Punkt gemessen</translation>
    </message>
    <message>
        <source>No preset is selected in the list.</source>
        <translation>In der Liste ist kein Preset gewählt.</translation>
    </message>
    <message>
        <source>No preset matches these words and tags.</source>
        <translation>Kein Preset passt zu diesen Wörtern und Tags.</translation>
    </message>
    <message>
        <source>no print has these values ({1}); correct it there.</source>
        <translation>kein Druck hat diese Werte ({=1}); korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>No ray grazes a shell along so many cells.</source>
        <translation>Kein Strahl streift eine Shell über so viele Zellen.</translation>
    </message>
    <message>
        <source>No ray meets the object so often.</source>
        <translation>Kein Strahl trifft das Objekt so oft.</translation>
    </message>
    <message>
        <source>no reflected rays are traced</source>
        <translation>es werden keine gespiegelten Strahlen verfolgt</translation>
    </message>
    <message>
        <source>No setting that was measured stays within {1}</source>
        <translation>Keine gemessene Einstellung bleibt innerhalb von {1}</translation>
    </message>
    <message>
        <source>No shape or operation matches.</source>
        <translation>Keine Form oder Operation passt.</translation>
    </message>
    <message>
        <source>no shown view has shadows</source>
        <translation>keine gezeigte Ansicht hat Schatten</translation>
    </message>
    <message>
        <source>no sky is in view</source>
        <translation>kein Himmel ist im Blick</translation>
    </message>
    <message>
        <source>no socket can be made there ({1}); choose a folder that you may write to.</source>
        <translation>Dort lässt sich kein Socket anlegen ({1}); wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>No sprites can be drawn: there is no graphics context.</source>
        <translation>Es können keine Sprites gezeichnet werden: Es gibt keinen Grafikkontext.</translation>
    </message>
    <message>
        <source>no such parameter</source>
        <translation>kein solcher Parameter</translation>
    </message>
    <message>
        <source>no sunbeam wider than 30 cm comes in by the window</source>
        <translation>durch das Fenster fällt kein Sonnenstrahl, der breiter als 30 cm ist</translation>
    </message>
    <message>
        <source>no sunbeam wider than 30 cm comes in by window or oculus</source>
        <translation>durch Fenster oder Oculus fällt kein Sonnenstrahl, der breiter als 30 cm ist</translation>
    </message>
    <message>
        <source>No views can be rendered: there is no graphics context.</source>
        <translation>Es können keine Ansichten gerendert werden: Es gibt keinen Grafikkontext.</translation>
    </message>
    <message>
        <source>No views could be read.</source>
        <translation>Keine Ansicht konnte gelesen werden.</translation>
    </message>
    <message>
        <source>No views could be rendered.</source>
        <translation>Keine Ansicht konnte gerendert werden.</translation>
    </message>
    <message>
        <source>no visible part has fins</source>
        <translation>kein sichtbarer Teil hat Fins</translation>
    </message>
    <message>
        <source>No way past the walls and what stands in the hall was found from the bookmark &quot;{1}&quot; to &quot;{2}&quot;; put another one between them.</source>
        <translation>Vom Lesezeichen „{=1}“ zu „{=2}“ fand sich kein Weg an den Wänden und dem, was in der Halle steht, vorbei; setzen Sie ein weiteres dazwischen.</translation>
    </message>
    <message>
        <source>no work uses baked noise</source>
        <translation>kein Werk verwendet gebackenes Rauschen</translation>
    </message>
    <message>
        <source>node under &quot;nodes&quot;</source>
        <translation>Knoten unter „nodes“</translation>
    </message>
    <message>
        <source>node {1} has two parents</source>
        <translation>Knoten {1} hat zwei Eltern</translation>
    </message>
    <message>
        <source>node {1} is named twice</source>
        <translation>Knoten {1} wird zweimal genannt</translation>
    </message>
    <message>
        <source>node {1} is not a root</source>
        <translation>Knoten {1} ist keine Wurzel</translation>
    </message>
    <message>
        <source>nodes are nested more than {1} deep</source>
        <translation>Knoten sind mehr als {1} tief verschachtelt</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Noise value above which space is solid: low fills space, high leaves islands.</source>
        <extracomment>tables</extracomment>
        <translation>Rauschwert, über dem der Raum fest ist: Niedrige Werte füllen den Raum, hohe lassen Inseln.</translation>
    </message>
    <message>
        <source>Noise value below which space is solid: -1 leaves nothing, 1 fills everything.</source>
        <translation>Rauschwert, unter dem der Raum fest ist: -1 lässt nichts, 1 füllt alles.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>None yet: drop a .glb or .gltf file on the window</source>
        <translation>Noch keine: eine .glb- oder .gltf-Datei auf dem Fenster ablegen</translation>
    </message>
    <message>
        <source>Noon</source>
        <translation>Mittag</translation>
    </message>
    <message>
        <source>noon</source>
        <translation>Mittag</translation>
    </message>
    <message>
        <source>Noon clouds</source>
        <translation>Mittagswolken</translation>
    </message>
    <message>
        <source>Noon sea</source>
        <translation>Meer am Mittag</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Normal method</source>
        <extracomment>tables</extracomment>
        <translation>Normalenverfahren</translation>
    </message>
    <message>
        <source>Normal of the plane, out of the solid.</source>
        <translation>Normale der Ebene, aus dem Körper heraus.</translation>
    </message>
    <message>
        <source>Normal scale</source>
        <extracomment>tables</extracomment>
        <translation>Normalenstärke</translation>
    </message>
    <message>
        <source>Normal step</source>
        <extracomment>tables</extracomment>
        <translation>Normalenschritt</translation>
    </message>
    <message>
        <source>Normals</source>
        <extracomment>tables</extracomment>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>normals</source>
        <extracomment>tables</extracomment>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>Normals against true ones</source>
        <translation>Normalen gegen wahre</translation>
    </message>
    <message>
        <source>Normals from depth, lines of one pixel, and few colors.</source>
        <translation>Normalen aus der Tiefe, Linien von einem Pixel und wenige Farben.</translation>
    </message>
    <message>
        <source>Normals of the field: by six further evaluations (differences), or by the analytic derivative.</source>
        <extracomment>tables</extracomment>
        <translation>Normalen des Felds: durch sechs weitere Auswertungen (Differenzen) oder durch die analytische Ableitung.</translation>
    </message>
    <message>
        <source>Not all files say on which machine they were measured, so their times cannot be compared: their work is, which counts the same anywhere.</source>
        <translation>Nicht alle Dateien sagen, auf welchem Rechner sie gemessen wurden, daher lassen sich ihre Zeiten nicht vergleichen: Verglichen wird ihre Arbeit, die überall gleich zählt.</translation>
    </message>
    <message>
        <source>Not all settings were timed: their work is compared, which counts the same anywhere.</source>
        <translation>Nicht bei allen Einstellungen wurde die Zeit gemessen: Verglichen wird ihre Arbeit, die überall gleich zählt.</translation>
    </message>
    <message>
        <source>Not at all</source>
        <translation>Gar nicht</translation>
    </message>
    <message>
        <source>not in the file yet</source>
        <translation>noch nicht in der Datei</translation>
    </message>
    <message>
        <source>not in the list</source>
        <translation>nicht in der Liste</translation>
    </message>
    <message>
        <source>Not saved: %1. Unsaved changes are kept in the session and restored at the next start.</source>
        <translation>Nicht gespeichert: %1. Ungespeicherte Änderungen bleiben in der Sitzung und sind beim nächsten Start wieder da.</translation>
    </message>
    <message>
        <source>not trusted</source>
        <translation>nicht verlässlich</translation>
    </message>
    <message>
        <source>Not used now; only used when %1. Its value is kept.</source>
        <translation>Zurzeit ohne Wirkung; wirkt nur, wenn %1. Der Wert bleibt erhalten.</translation>
    </message>
    <message>
        <source>Nothing can be drawn: there is no graphics context.</source>
        <translation>Es kann nichts gezeichnet werden: Es gibt keinen Grafikkontext.</translation>
    </message>
    <message>
        <source>Nothing can be measured: there is no graphics context.</source>
        <translation>Es kann nichts gemessen werden: Es gibt keinen Grafikkontext.</translation>
    </message>
    <message>
        <source>Nothing depends on {1} at present: every setting gives the same picture. Switch on what it acts on, and study again.</source>
        <translation>Von {1} hängt zurzeit nichts ab: Jede Einstellung gibt dasselbe Bild. Schalten Sie ein, worauf es wirkt, und untersuchen Sie noch einmal.</translation>
    </message>
    <message>
        <source>nothing in the picture is translucent</source>
        <translation>nichts im Bild ist durchscheinend</translation>
    </message>
    <message>
        <source>Nothing in the scene is as thick as a cell; nothing was written. Give a smaller --cell, or a thickness to the sheets of the scene.</source>
        <translation>Nichts in der Szene ist so dick wie eine Zelle; nichts wurde geschrieben. Geben Sie ein kleineres --cell an, oder den Flächen der Szene eine Dicke.</translation>
    </message>
    <message>
        <source>nothing in the scene mirrors</source>
        <translation>nichts in der Szene spiegelt</translation>
    </message>
    <message>
        <source>Nothing is changed.</source>
        <translation>Nichts wird geändert.</translation>
    </message>
    <message>
        <source>Nothing is drawn yet.</source>
        <translation>Noch ist nichts gezeichnet.</translation>
    </message>
    <message>
        <source>nothing is made of glass</source>
        <translation>nichts ist aus Glas</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Noch ist nichts gemessen.</translation>
    </message>
    <message>
        <source>nothing measurable</source>
        <translation>nichts Messbares</translation>
    </message>
    <message>
        <source>nothing moves</source>
        <translation>nichts bewegt sich</translation>
    </message>
    <message>
        <source>Nothing of the scene lies between --low and --high; give other corners.</source>
        <translation>Zwischen --low und --high liegt nichts von der Szene; geben Sie andere Ecken an.</translation>
    </message>
    <message>
        <source>nothing of the visitor's object is translucent</source>
        <translation>nichts am Objekt des Besuchers ist durchscheinend</translation>
    </message>
    <message>
        <source>Nothing of {1} is to be seen: every pixel of every frame is empty; choose an object with more opacity, or larger frames.</source>
        <translation>Von {1} ist nichts zu sehen: Jedes Pixel jedes Frames ist leer; wählen Sie ein Objekt mit mehr Deckkraft oder größere Frames.</translation>
    </message>
    <message>
        <source>Nothing of {1} is to be seen: it has no triangles; choose another file, or export it with its meshes.</source>
        <translation>Von {1} ist nichts zu sehen: Es hat keine Dreiecke; wählen Sie eine andere Datei, oder exportieren Sie es mit seinen Meshes.</translation>
    </message>
    <message>
        <source>Nothing of {1} is to be seen: it is scaled to a point or a line; export it with a scale other than 0.</source>
        <translation>Von {1} ist nichts zu sehen: Es ist zu einem Punkt oder einer Linie skaliert; exportieren Sie es mit einer Skalierung ungleich 0.</translation>
    </message>
    <message>
        <source>nothing so cheap was measured</source>
        <translation>nichts so Billiges wurde gemessen</translation>
    </message>
    <message>
        <source>nothing so exact was measured</source>
        <translation>nichts so Genaues wurde gemessen</translation>
    </message>
    <message>
        <source>Nothing solid lies between --low and --high; nothing was written. Give other corners, or a smaller --cell for what is thinner than a cell.</source>
        <translation>Zwischen --low und --high liegt nichts Festes; nichts wurde geschrieben. Geben Sie andere Ecken an, oder ein kleineres --cell für das, was dünner als eine Zelle ist.</translation>
    </message>
    <message>
        <source>Nothing to look at yet</source>
        <translation>Noch nichts zu sehen</translation>
    </message>
    <message>
        <source>Nothing to print yet</source>
        <translation>Noch nichts zu drucken</translation>
    </message>
    <message>
        <source>nothing was drawn before</source>
        <translation>davor wurde nichts gezeichnet</translation>
    </message>
    <message>
        <source>Nothing was exported: select a preset in the list first.</source>
        <translation>Nichts wurde exportiert: Wählen Sie zuerst ein Preset in der Liste.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Number of bars up the side of the foot.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Stäbe an der Seite des Fußes.</translation>
    </message>
    <message>
        <source>Number of cells around a point whose flames light it.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Zellen um einen Punkt, deren Flammen ihn beleuchten.</translation>
    </message>
    <message>
        <source>Number of colors of the frames' own palette.</source>
        <translation>Anzahl der Farben in der eigenen Palette der Bilder.</translation>
    </message>
    <message>
        <source>Number of colors taken from the picture.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Farben, die aus dem Bild genommen werden.</translation>
    </message>
    <message>
        <source>Number of cones around the axis of this layer.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Kegel um die Achse dieser Schicht.</translation>
    </message>
    <message>
        <source>Number of copies along x, y and z; 0 is infinitely many.</source>
        <translation>Zahl der Kopien entlang x, y und z; 0 sind unendlich viele.</translation>
    </message>
    <message>
        <source>Number of copies.</source>
        <translation>Zahl der Kopien.</translation>
    </message>
    <message>
        <source>Number of files listed in File &gt; Open recent; 0 lists none.</source>
        <translation>Zahl der Dateien unter Datei &gt; Zuletzt geöffnet; 0 behält keine.</translation>
    </message>
    <message>
        <source>Number of frames averaged while the picture moves: few flicker, many blur fine details.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Frames, über die ein bewegtes Bild gemittelt wird: Wenige flimmern, viele verwischen Feines.</translation>
    </message>
    <message>
        <source>Number of frames per direction, evenly spaced over the animation. Auto: 12 of what is animated, else 1.</source>
        <translation>Anzahl der Bilder je Richtung, gleichmäßig über die Animation verteilt. Automatisch: 12, wo etwas animiert ist, sonst 1.</translation>
    </message>
    <message>
        <source>Number of grid cells for lanterns, in a square whose corner is at the frame: low is a few, high reaches to the horizon.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Gitterzellen für Laternen, in einem Quadrat, dessen Ecke am Rahmen liegt: Niedrige Werte sind wenige, hohe reichen bis zum Horizont.</translation>
    </message>
    <message>
        <source>Number of layers (shells) drawn from tip to skin: few show gaps, many are more accurate and cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Schichten (Shells), die von der Spitze zur Haut gezeichnet werden: Wenige zeigen Lücken, viele sind genauer und teurer.</translation>
    </message>
    <message>
        <source>Number of lenses across the card; the shape of the sheet is scaled to fit. 0 follows from the LPI of the sheet.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Linsen quer über die Karte; die Form der Folie wird passend skaliert. 0 folgt aus dem LPI-Wert der Folie.</translation>
    </message>
    <message>
        <source>Number of lenses per inch of the custom sheet.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Linsen pro Zoll der eigenen Folie.</translation>
    </message>
    <message>
        <source>Number of mesh cells along the longest side of the box: few show facets in the reflections.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Netzzellen entlang der längsten Seite des Quaders: Wenige zeigen Facetten in den Spiegelungen.</translation>
    </message>
    <message>
        <source>Number of normals across a lens whose reflections are averaged: few show streaks.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Normalen quer über eine Linse, deren Spiegelungen gemittelt werden: Wenige zeigen Streifen.</translation>
    </message>
    <message>
        <source>Number of octaves of the clouds' noise: each adds finer detail.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Oktaven des Wolkenrauschens: Jede fügt feinere Details hinzu.</translation>
    </message>
    <message>
        <source>Number of octaves that are summed: each adds finer detail.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Oktaven, die summiert werden: Jede fügt feinere Details hinzu.</translation>
    </message>
    <message>
        <source>Number of orders of scattering that are summed: 1 leaves clouds dark inside, each further one makes them whiter.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Streuordnungen, die summiert werden: 1 lässt Wolken innen dunkel, jede weitere macht sie weißer.</translation>
    </message>
    <message>
        <source>Number of rays over each light, for the area method: few are noisy, many cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Strahlen über jedes Licht, für das Flächenverfahren: Wenige rauschen, viele kosten mehr.</translation>
    </message>
    <message>
        <source>Number of rays over the hemisphere, denser along the normal: few are noisy, many cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Strahlen über die Halbkugel, dichter entlang der Normalen: Wenige rauschen, viele kosten mehr.</translation>
    </message>
    <message>
        <source>Number of rays over the sun's disk, for the area method: few are noisy, many cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Strahlen über die Sonnenscheibe, für das Flächenverfahren: Wenige rauschen, viele kosten mehr.</translation>
    </message>
    <message>
        <source>Number of rays traced over a lens, or over the part of it under a pixel: few show steps between views, many are smooth.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Strahlen über eine Linse oder über den Teil davon unter einem Pixel: Wenige zeigen Stufen zwischen Ansichten, viele sind glatt.</translation>
    </message>
    <message>
        <source>Number of rings around the foot, evenly spaced over its height.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Ringe um den Fuß, gleichmäßig über seine Höhe verteilt.</translation>
    </message>
    <message>
        <source>Number of ripples that are summed, from the longest: few are smooth, many add fine ones.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Kräuselwellen, die summiert werden, von der längsten an: Wenige sind glatt, viele fügen feine hinzu.</translation>
    </message>
    <message>
        <source>Number of rows of cells in which a ray searches for lanterns; lanterns beyond are drawn as their average.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Zellenreihen, in denen ein Strahl nach Laternen sucht; Laternen dahinter werden als ihr Mittel gezeichnet.</translation>
    </message>
    <message>
        <source>Number of samples along a ray: few show bands. Each of the three passes takes the cube root of it, the polar grid has two cells per sample.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Samples entlang eines Strahls: Wenige zeigen Streifen. Jeder der drei Passes nimmt die dritte Wurzel davon, das Polargitter hat zwei Zellen pro Sample.</translation>
    </message>
    <message>
        <source>Number of samples along the normal that darken what is hidden from the ambient light: few are coarse.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Samples entlang der Normalen, die abdunkeln, was dem Umgebungslicht verborgen ist: Wenige sind grob.</translation>
    </message>
    <message>
        <source>Number of samples per pixel to which an idle picture is refined: few leave jagged edges, many take longer.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Samples pro Pixel, bis zu denen ein ruhendes Bild verfeinert wird: Wenige lassen Treppen an Kanten, viele brauchen länger.</translation>
    </message>
    <message>
        <source>Number of samples per texel with which the reflection probe is blurred for rough surfaces: few are noisy.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Samples pro Texel, mit denen die Reflexionssonde für raue Oberflächen weichgezeichnet wird: Wenige rauschen.</translation>
    </message>
    <message>
        <source>Number of shadow-map comparisons over the sun's disk in a half-shadow: few are noisy, many cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Vergleiche in der Shadow-Map über die Sonnenscheibe in einem Halbschatten: Wenige rauschen, viele kosten mehr.</translation>
    </message>
    <message>
        <source>Number of spring steps per second: with few, the two Euler methods fail.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Federschritte pro Sekunde: Bei wenigen versagen die beiden Euler-Verfahren.</translation>
    </message>
    <message>
        <source>Number of sprinkles on the cream, placed at random.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Streusel auf dem Eis, zufällig verteilt.</translation>
    </message>
    <message>
        <source>Number of steps in which a ray crosses the beams of the volume: few are noisy, many cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Schritte, in denen ein Strahl die Lichtstrahlen des Volumens durchquert: Wenige rauschen, viele kosten mehr.</translation>
    </message>
    <message>
        <source>Number of steps of a ray through the clouds: few are noisy, many cost more.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Schritte eines Strahls durch die Wolken: Wenige rauschen, viele kosten mehr.</translation>
    </message>
    <message>
        <source>Number of steps towards the sun from each point in a cloud.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Schritte zur Sonne von jedem Punkt einer Wolke.</translation>
    </message>
    <message>
        <source>Number of strands along one side of a tuft: low makes fine tufts, high makes broad ones.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Haare entlang einer Seite eines Büschels: Niedrige Werte geben feine Büschel, hohe breite.</translation>
    </message>
    <message>
        <source>Number of strands per square meter: low is thin fur, high is dense.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Haare pro Quadratmeter: Niedrige Werte geben dünnes Fell, hohe dichtes.</translation>
    </message>
    <message>
        <source>Number of the model's animation to play, in the order of its file; 0 is none. Beyond the last, the last is played.</source>
        <extracomment>tables</extracomment>
        <translation>Nummer der Animation des Modells, die abgespielt wird, in der Reihenfolge seiner Datei; 0 ist keine. Über die letzte hinaus wird die letzte abgespielt.</translation>
    </message>
    <message>
        <source>Number of times a reflected ray may meet the object again before it sees only the hall: 0 is cheapest.</source>
        <extracomment>tables</extracomment>
        <translation>Wie oft ein gespiegelter Strahl das Objekt wieder treffen darf, bevor er nur noch die Halle sieht: 0 kostet am wenigsten.</translation>
    </message>
    <message>
        <source>Number of times that the water may reflect a ray: 0 shows no reflections.</source>
        <extracomment>tables</extracomment>
        <translation>Wie oft das Wasser einen Strahl spiegeln darf: 0 zeigt keine Spiegelungen.</translation>
    </message>
    <message>
        <source>Number of tones from shade to light, as in hand-drawn pixel art; 1 shades smoothly.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Töne von Schatten bis Licht, wie bei gezeichneter Pixel-Art; 1 ist ohne Stufen.</translation>
    </message>
    <message>
        <source>Number of turns of a curl from skin to tip.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Windungen einer Locke von der Haut zur Spitze.</translation>
    </message>
    <message>
        <source>Number of view directions, evenly spaced around the object.</source>
        <translation>Anzahl der Blickrichtungen, gleichmäßig um das Objekt verteilt.</translation>
    </message>
    <message>
        <source>Number of views under each lens, chosen evenly from those of the print; never more than it has.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Ansichten unter jeder Linse, gleichmäßig aus denen des Drucks gewählt; nie mehr, als er hat.</translation>
    </message>
    <message>
        <source>Number of waves that are summed, from the longest: few are smooth, many add small waves.</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Wellen, die summiert werden, von der längsten an: Wenige sind glatt, viele fügen kleine Wellen hinzu.</translation>
    </message>
    <message>
        <source>Number to read</source>
        <translation>Abzulesende Zahl</translation>
    </message>
    <message>
        <source>numbers are folded by themselves where the evaluation is automatic</source>
        <translation>Zahlen werden von selbst eingerechnet, wo die Auswertung automatisch ist</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Object outlines</source>
        <extracomment>tables</extracomment>
        <translation>Objektumrisse</translation>
    </message>
    <message>
        <source>Object that is drawn: a glTF 2.0 file (.glb, .gltf), whose animation is played. Without one, the torus over its pillar.</source>
        <translation>Objekt, das gezeichnet wird: eine glTF-2.0-Datei (.glb, .gltf), deren Animation abgespielt wird. Ohne Datei der Torus über seiner Säule.</translation>
    </message>
    <message>
        <source>objects and arrays are nested more than {1} deep</source>
        <translation>Objekte und Arrays sind mehr als {1} tief verschachtelt</translation>
    </message>
    <message>
        <source>occluders</source>
        <extracomment>tables</extracomment>
        <translation>Verdecker</translation>
    </message>
    <message>
        <source>occlusion</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>Occlusion attenuation</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungsabfall</translation>
    </message>
    <message>
        <source>Occlusion bias</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungs-Bias</translation>
    </message>
    <message>
        <source>Occlusion method</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungsverfahren</translation>
    </message>
    <message>
        <source>Occlusion method of the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungsverfahren der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Occlusion range</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungsweite</translation>
    </message>
    <message>
        <source>Occlusion rays</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungsstrahlen</translation>
    </message>
    <message>
        <source>Occlusion taps</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckungs-Samples</translation>
    </message>
    <message>
        <source>Octave rotation</source>
        <extracomment>tables</extracomment>
        <translation>Oktavdrehung</translation>
    </message>
    <message>
        <source>Octaves</source>
        <extracomment>tables</extracomment>
        <translation>Oktaven</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Of its layers {1} is read; &quot;{2}&quot; and others are left out.</source>
        <translation>Von seinen Ebenen wird {1} gelesen; „{2}“ und andere fallen weg.</translation>
    </message>
    <message>
        <source>Of its layers {1} is read; &quot;{2}&quot; is left out.</source>
        <translation>Von seinen Ebenen wird {1} gelesen; „{2}“ fällt weg.</translation>
    </message>
    <message>
        <source>Of the raster, bleed included.</source>
        <translation>Des Rasters, mit Anschnitt.</translation>
    </message>
    <message>
        <source>Of the videos only .webp and .apng can be transparent; choose one of them, or frames of PNG.</source>
        <translation>Von den Videos können nur .webp und .apng transparent sein; wählen Sie eines davon, oder Frames als PNG.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Offset x</source>
        <extracomment>tables</extracomment>
        <translation>Versatz x</translation>
    </message>
    <message>
        <source>Offset z</source>
        <extracomment>tables</extracomment>
        <translation>Versatz z</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Old gold</source>
        <translation>Altes Gold</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>On its way round the camera runs into a wall or what stands in the hall; turn by a smaller angle.</source>
        <translation>Auf ihrem Weg ringsum stößt die Kamera an eine Wand oder etwas, das in der Halle steht; drehen Sie um einen kleineren Winkel.</translation>
    </message>
    <message>
        <source>on or off</source>
        <translation>on oder off</translation>
    </message>
    <message>
        <source>on show</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>one</source>
        <extracomment>tables</extracomment>
        <translation>eine</translation>
    </message>
    <message>
        <source>one bit</source>
        <extracomment>tables</extracomment>
        <translation>ein Bit</translation>
    </message>
    <message>
        <source>One body with one hole: a distance field, found anew by every ray.</source>
        <translation>Ein Körper mit einem Loch: ein Distanzfeld, von jedem Strahl neu gefunden.</translation>
    </message>
    <message>
        <source>one cone</source>
        <extracomment>tables</extracomment>
        <translation>ein Kegel</translation>
    </message>
    <message>
        <source>one for every texel</source>
        <translation>eine für jedes Texel</translation>
    </message>
    <message>
        <source>One lantern</source>
        <translation>Eine Laterne</translation>
    </message>
    <message>
        <source>one of its keys is longer than {1} bytes.</source>
        <translation>einer der Schlüssel ist länger als {1} Bytes.</translation>
    </message>
    <message>
        <source>one of its values is not a finite number; export the file again.</source>
        <translation>einer der Werte ist keine endliche Zahl; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>one of them names a vertex beyond the {1} that there are</source>
        <translation>einer davon nennt eine Ecke jenseits der {1} vorhandenen</translation>
    </message>
    <message>
        <source>one of them names no node; export the file again.</source>
        <translation>einer davon nennt keinen Knoten; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>one of {1}</source>
        <translation>eines von {=1}</translation>
    </message>
    <message>
        <source>one sample per pixel</source>
        <translation>ein Sample pro Pixel</translation>
    </message>
    <message>
        <source>One step; the wheel only in the field with the focus</source>
        <translation>Ein Schritt; das Mausrad nur im Feld mit dem Fokus</translation>
    </message>
    <message>
        <source>Only an operation of one child can be taken away from around it.</source>
        <translation>Nur eine Operation mit einem Kind lässt sich darum herum wegnehmen.</translation>
    </message>
    <message>
        <source>only B: %1</source>
        <translation>nur B: %1</translation>
    </message>
    <message>
        <source>only blocks of JSON are read; begin it with ```json.</source>
        <translation>nur JSON-Blöcke werden gelesen; beginnen Sie ihn mit ```json.</translation>
    </message>
    <message>
        <source>Only changed</source>
        <translation>Nur geänderte</translation>
    </message>
    <message>
        <source>only depth is shown</source>
        <translation>gezeigt wird nur die Tiefe</translation>
    </message>
    <message>
        <source>only one exhibit is requested, without its surroundings</source>
        <translation>nur ein Exponat ist verlangt, ohne seine Umgebung</translation>
    </message>
    <message>
        <source>Only one of its {1} parts is read.</source>
        <translation>Nur einer seiner {1} Teile wird gelesen.</translation>
    </message>
    <message>
        <source>Only prints with vertical lenses can be cut into tiles.</source>
        <translation>Nur Drucke mit senkrechten Linsen lassen sich in Kacheln schneiden.</translation>
    </message>
    <message>
        <source>only the beams are shown</source>
        <translation>nur die Strahlen werden gezeigt</translation>
    </message>
    <message>
        <source>Only the chosen exhibit</source>
        <translation>Nur das gewählte Exponat</translation>
    </message>
    <message>
        <source>Only the default scene is shown.</source>
        <translation>Nur die Standardszene wird gezeigt.</translation>
    </message>
    <message>
        <source>Only the first of its {1} pages is read.</source>
        <translation>Nur die erste seiner {1} Seiten wird gelesen.</translation>
    </message>
    <message>
        <source>opaque</source>
        <extracomment>tables</extracomment>
        <translation>undurchsichtig</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Open as B</source>
        <translation>Als B öffnen</translation>
    </message>
    <message>
        <source>Open lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Open lesson %1</source>
        <translation>Lektion %1 öffnen</translation>
    </message>
    <message>
        <source>OpenGL %1.%2 found, 4.5 core needed (%3): update the graphics driver, or install Mesa's software renderer (package libgl1-mesa-dri).</source>
        <translation>OpenGL %1.%2 gefunden, nötig ist 4.5 Core (%3): Aktualisieren Sie den Grafiktreiber, oder installieren Sie Mesas Software-Renderer (Paket libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>OpenGL 4.5 is needed, but no OpenGL context could be made: install a graphics driver, or Mesa's software renderer (package libgl1-mesa-dri).</source>
        <translation>OpenGL 4.5 ist nötig, aber ein OpenGL-Kontext ließ sich nicht anlegen: Installieren Sie einen Grafiktreiber, oder Mesas Software-Renderer (Paket libgl1-mesa-dri).</translation>
    </message>
    <message>
        <source>OpenGL {1} found ({2}), OpenGL 4.5 needed: update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1 to draw with Mesa's software renderer.</source>
        <translation>OpenGL {1} gefunden ({=2}), nötig ist OpenGL 4.5: Aktualisieren Sie den Grafiktreiber, oder setzen Sie LIBGL_ALWAYS_SOFTWARE=1, um mit Mesas Software-Renderer zu zeichnen.</translation>
    </message>
    <message>
        <source>OpenImageIO failed</source>
        <translation>OpenImageIO ist gescheitert</translation>
    </message>
    <message>
        <source>OpenImageIO failed ({1})</source>
        <translation>OpenImageIO ist gescheitert ({=1})</translation>
    </message>
    <message>
        <source>opening it</source>
        <translation>das Öffnen</translation>
    </message>
    <message>
        <source>opening it again</source>
        <translation>das erneute Öffnen</translation>
    </message>
    <message>
        <source>Opening the hall …</source>
        <translation>Die Halle wird geöffnet …</translation>
    </message>
    <message>
        <source>Opens %1.</source>
        <translation>Öffnet %1.</translation>
    </message>
    <message>
        <source>Opens a lesson of your own (Markdown); the manual explains the format.</source>
        <translation>Öffnet eine eigene Lektion (Markdown); das Handbuch erklärt das Format.</translation>
    </message>
    <message>
        <source>Opens a page with all lessons: their order, aims, times and prerequisites.</source>
        <translation>Öffnet eine Seite mit allen Lektionen: Reihenfolge, Ziele, Dauer und Voraussetzungen.</translation>
    </message>
    <message>
        <source>Opens the page about the visited exhibit: its technique, figures, formulas, sources.</source>
        <translation>Öffnet die Seite über das besuchte Exponat: Technik, Abbildungen, Formeln, Quellen.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>operators</source>
        <translation>Operatoren</translation>
    </message>
    <message>
        <source>Opposite corner of the part that is meshed.</source>
        <translation>Gegenüberliegende Ecke des Teils, der vernetzt wird.</translation>
    </message>
    <message>
        <source>Optical thickness of the paper, as the mean number of scattering events: low is clear and bright, high is dim and white.</source>
        <extracomment>tables</extracomment>
        <translation>Optische Dicke des Papiers, als mittlere Zahl der Streuungen: Niedrige Werte sind klar und hell, hohe trüb und weiß.</translation>
    </message>
    <message>
        <source>Orbit</source>
        <extracomment>tables</extracomment>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>Orbit angle</source>
        <extracomment>tables</extracomment>
        <translation>Umlaufwinkel</translation>
    </message>
    <message>
        <source>Orbit speed</source>
        <extracomment>tables</extracomment>
        <translation>Umlauftempo</translation>
    </message>
    <message>
        <source>Order in which shells are drawn: outer shells first hide the inner ones early and save work. The picture is the same.</source>
        <extracomment>tables</extracomment>
        <translation>Reihenfolge, in der die Shells gezeichnet werden: Äußere zuerst verdecken die inneren früh und sparen Arbeit. Das Bild ist dasselbe.</translation>
    </message>
    <message>
        <source>Order of the depth values: reversed has 1 near and 0 far, standard the opposite.</source>
        <extracomment>tables</extracomment>
        <translation>Ordnung der Tiefenwerte: Umgekehrt ist nah 1 und fern 0, bei Standard andersherum.</translation>
    </message>
    <message>
        <source>Order of the lessons (for &amp;teachers)</source>
        <translation>Reihenfolge der Lektionen (für Lehren&amp;de)</translation>
    </message>
    <message>
        <source>ordered</source>
        <extracomment>tables</extracomment>
        <translation>geordnet</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>orthographic</source>
        <extracomment>tables</extracomment>
        <translation>orthografisch</translation>
    </message>
    <message>
        <source>Our own is shown in its place until it can be read.</source>
        <translation>Unser eigener wird an seiner Stelle gezeigt, bis er gelesen werden kann.</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>außer Sicht</translation>
    </message>
    <message>
        <source>outer first</source>
        <extracomment>tables</extracomment>
        <translation>äußere zuerst</translation>
    </message>
    <message>
        <source>Outline color</source>
        <extracomment>tables</extracomment>
        <translation>Umrissfarbe</translation>
    </message>
    <message>
        <source>Outline gap</source>
        <extracomment>tables</extracomment>
        <translation>Umrissabstand</translation>
    </message>
    <message>
        <source>Outline strength</source>
        <extracomment>tables</extracomment>
        <translation>Umrissstärke</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Output file of the print. Its settings are written inside and beside it.</source>
        <translation>Ausgabedatei des Drucks. Seine Einstellungen werden hinein und daneben geschrieben.</translation>
    </message>
    <message>
        <source>Output file. Further files take its name, and the settings lie beside it.</source>
        <translation>Ausgabedatei. Weitere Dateien nehmen ihren Namen an, und die Einstellungen liegen daneben.</translation>
    </message>
    <message>
        <source>over the water</source>
        <translation>über das Wasser</translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation>Bedeckt</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>own cell</source>
        <extracomment>tables</extracomment>
        <translation>eigene Zelle</translation>
    </message>
    <message>
        <source>own plinth</source>
        <extracomment>tables</extracomment>
        <translation>eigener Sockel</translation>
    </message>
    <message>
        <source>Palette</source>
        <extracomment>tables</extracomment>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Palette colors</source>
        <extracomment>tables</extracomment>
        <translation>Palettenfarben</translation>
    </message>
    <message>
        <source>Palette of all frames: their own, made of their colors, or a shipped one.</source>
        <translation>Palette aller Bilder: ihre eigene, aus ihren Farben gebildet, oder eine mitgelieferte.</translation>
    </message>
    <message>
        <source>Palette picture</source>
        <extracomment>tables</extracomment>
        <translation>Palettenbild</translation>
    </message>
    <message>
        <source>Palette that limits the colors: none, made for the isle, of an old machine, or of a picture of the hall (golden hour).</source>
        <extracomment>tables</extracomment>
        <translation>Palette, die die Farben begrenzt: keine, für die Insel gemacht, die eines alten Geräts oder die eines Bildes der Halle (goldene Stunde).</translation>
    </message>
    <message>
        <source>Pan x</source>
        <extracomment>tables</extracomment>
        <translation>Verschiebung x</translation>
    </message>
    <message>
        <source>Pan y</source>
        <extracomment>tables</extracomment>
        <translation>Verschiebung y</translation>
    </message>
    <message>
        <source>Panorama</source>
        <extracomment>tables</extracomment>
        <translation>Panorama</translation>
    </message>
    <message>
        <source>Panorama picture, twice as wide as high.</source>
        <translation>Panoramabild, doppelt so breit wie hoch.</translation>
    </message>
    <message>
        <source>Paper</source>
        <extracomment>tables</extracomment>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Paper color</source>
        <extracomment>tables</extracomment>
        <translation>Papierfarbe</translation>
    </message>
    <message>
        <source>Paper height</source>
        <extracomment>tables</extracomment>
        <translation>Papierhöhe</translation>
    </message>
    <message>
        <source>Paper Lanterns</source>
        <translation>Papierlaternen</translation>
    </message>
    <message>
        <source>Paper radius</source>
        <extracomment>tables</extracomment>
        <translation>Papierradius</translation>
    </message>
    <message>
        <source>Paper thickness</source>
        <extracomment>tables</extracomment>
        <translation>Papierdicke</translation>
    </message>
    <message>
        <source>Paper wall</source>
        <extracomment>tables</extracomment>
        <translation>Papierwand</translation>
    </message>
    <message>
        <source>parabola</source>
        <extracomment>tables</extracomment>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>Parallax</source>
        <extracomment>tables</extracomment>
        <translation>Parallaxe</translation>
    </message>
    <message>
        <source>parameter of the scene</source>
        <translation>Parameter der Szene</translation>
    </message>
    <message>
        <source>Parameter of this scene.</source>
        <translation>Parameter dieser Szene.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>paraxial</source>
        <extracomment>tables</extracomment>
        <translation>paraxial</translation>
    </message>
    <message>
        <source>part</source>
        <extracomment>tables</extracomment>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Part of a strip that its two blended edges take.</source>
        <translation>Teil eines Streifens, den seine beiden weichen Ränder einnehmen.</translation>
    </message>
    <message>
        <source>Part of the ice cream to show: one alone, or all.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigter Teil des Eises: einer allein oder alle.</translation>
    </message>
    <message>
        <source>parts</source>
        <extracomment>tables</extracomment>
        <translation>Teile</translation>
    </message>
    <message>
        <source>parts of the model are translucent</source>
        <translation>Teile des Modells sind durchscheinend</translation>
    </message>
    <message>
        <source>Parts of the session are unknown to this version; it was kept as %1:</source>
        <translation>Nicht alles in der Sitzung ist dieser Version bekannt; sie wurde als %1 aufbewahrt:</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>Past all exhibits</source>
        <translation>An allen Exponaten vorbei</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Paste all</source>
        <translation>Alle einfügen</translation>
    </message>
    <message>
        <source>Paste all values</source>
        <translation>Alle Werte einfügen</translation>
    </message>
    <message>
        <source>Path of a glTF 2.0 file (.glb or .gltf) that replaces the small world.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad einer Datei in glTF 2.0 (.glb oder .gltf), die die kleine Welt ersetzt.</translation>
    </message>
    <message>
        <source>Path of a glTF object (.glb or .gltf) to show, at first on the free plinth.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad eines glTF-Objekts (.glb oder .gltf), das gezeigt wird, zuerst auf dem freien Sockel.</translation>
    </message>
    <message>
        <source>Path of a glTF object that wears the ring's coat in place of the ring; models/teddy.glb is supplied.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad eines glTF-Objekts, das statt des Rings dessen Fell trägt; models/teddy.glb liegt bei.</translation>
    </message>
    <message>
        <source>Path of a panorama that replaces the sky: HDR, EXR, or an ordinary picture twice as wide as high.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad eines Panoramas, das den Himmel ersetzt: HDR, EXR oder ein gewöhnliches Bild, doppelt so breit wie hoch.</translation>
    </message>
    <message>
        <source>Path of a panorama, twice as wide as high, that replaces the night sky.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad eines Panoramas, doppelt so breit wie hoch, das den Nachthimmel ersetzt.</translation>
    </message>
    <message>
        <source>Path of a picture whose main colors replace the palette.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad eines Bildes, dessen Hauptfarben die Palette ersetzen.</translation>
    </message>
    <message>
        <source>Path of a scene of shapes (JSON); its format is described in assets/scenes/scene.schema.json.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad einer Formenszene (JSON); ihr Format beschreibt assets/scenes/scene.schema.json.</translation>
    </message>
    <message>
        <source>Path of one more glTF object (.glb or .gltf) to show, at first on a plinth of its own.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad eines weiteren glTF-Objekts (.glb oder .gltf), das gezeigt wird, zuerst auf einem eigenen Sockel.</translation>
    </message>
    <message>
        <source>Path of the lantern that the button releases: up into the air, or away on the water.</source>
        <extracomment>tables</extracomment>
        <translation>Weg der Laterne, die der Knopf freilässt: hinauf in die Luft oder davon auf dem Wasser.</translation>
    </message>
    <message>
        <source>Path of the views of the first print: a folder of pictures, or a file written by “vitrine print”. Empty: the turning mug.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad der Ansichten des ersten Drucks: ein Ordner mit Bildern oder eine Datei von „vitrine print“. Leer: die sich drehende Tasse.</translation>
    </message>
    <message>
        <source>Path of the views of the second print: a folder of pictures, or a file written by “vitrine print”. Empty: the melting torus.</source>
        <extracomment>tables</extracomment>
        <translation>Pfad der Ansichten des zweiten Drucks: ein Ordner mit Bildern oder eine Datei von „vitrine print“. Leer: der schmelzende Torus.</translation>
    </message>
    <message>
        <source>Pattern that hints at colors between those of the palette. Ordered and blue noise stay where they are from frame to frame.</source>
        <translation>Muster, das Farben zwischen denen der Palette andeutet. Geordnet und blaues Rauschen bleiben von Bild zu Bild an ihrem Platz.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Pause &amp;clock</source>
        <translation>&amp;Uhr anhalten</translation>
    </message>
    <message>
        <source>Pbr</source>
        <translation>PBR</translation>
    </message>
    <message>
        <source>peak signal to noise ratio, dB</source>
        <translation>Spitzen-Signal-Rausch-Verhältnis, dB</translation>
    </message>
    <message>
        <source>Percent of the view's height; negative numbers shift it up.</source>
        <translation>Prozent der Höhe der Ansicht; negative Zahlen verschieben sie nach oben.</translation>
    </message>
    <message>
        <source>Percent of the view's width; negative numbers shift it to the left.</source>
        <translation>Prozent der Breite der Ansicht; negative Zahlen verschieben sie nach links.</translation>
    </message>
    <message>
        <source>Period</source>
        <extracomment>tables</extracomment>
        <translation>Periode</translation>
    </message>
    <message>
        <source>perspective</source>
        <extracomment>tables</extracomment>
        <translation>perspektivisch</translation>
    </message>
    <message>
        <source>Phase</source>
        <extracomment>tables</extracomment>
        <translation>Phase</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Phase of the flickering: all flames together, or each on its own.</source>
        <extracomment>tables</extracomment>
        <translation>Phase des Flackerns: alle Flammen gemeinsam oder jede für sich.</translation>
    </message>
    <message>
        <source>Phong</source>
        <translation>Phong</translation>
    </message>
    <message>
        <source>Phong shading with a mirror, as in the reference of these scenes.</source>
        <translation>Phong-Beleuchtung mit Spiegel, wie in der Referenz dieser Szenen.</translation>
    </message>
    <message>
        <source>physically based</source>
        <extracomment>tables</extracomment>
        <translation>physikalisch basiert</translation>
    </message>
    <message>
        <source>Physically based material: metal, glaze, stone or glass.</source>
        <translation>Physikalisches Material: Metall, Glasur, Stein oder Glas.</translation>
    </message>
    <message>
        <source>PICO-8</source>
        <extracomment>tables</extracomment>
        <translation>PICO-8</translation>
    </message>
    <message>
        <source>Picture</source>
        <extracomment>tables</extracomment>
        <translation>Bild</translation>
    </message>
    <message>
        <source>picture</source>
        <extracomment>tables</extracomment>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Picture and mouse</source>
        <translation>Bild und Maus</translation>
    </message>
    <message>
        <source>Picture and reference</source>
        <translation>Bild und Referenz</translation>
    </message>
    <message>
        <source>Picture saved to %1.</source>
        <translation>Bild als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Picture to show in the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigtes Bild in der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Picture to show: the finished one, or a step on the way to it.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigtes Bild: das fertige oder ein Schritt auf dem Weg dorthin.</translation>
    </message>
    <message>
        <source>Picture to show: the finished one, the height of the water, its normals, or the parts of the lanterns in separate colors.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigtes Bild: das fertige, die Höhe des Wassers, seine Normalen oder die Teile der Laternen in eigenen Farben.</translation>
    </message>
    <message>
        <source>Picture to show: the finished one, the mask with its occluders black, or only the added light without the hall.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigtes Bild: das fertige, die Maske mit schwarzen Verdeckern oder nur das hinzugefügte Licht ohne die Halle.</translation>
    </message>
    <message>
        <source>picture {1} of {2}</source>
        <translation>Bild {1} von {2}</translation>
    </message>
    <message>
        <source>picture.{1} is not known here; it is left out</source>
        <translation>picture.{=1} ist hier nicht bekannt; es wird weggelassen</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Pictures in viewing order from the left.</source>
        <translation>Bilder in der Reihenfolge des Betrachtens, von links.</translation>
    </message>
    <message>
        <source>Pictures of the study</source>
        <translation>Bilder der Studie</translation>
    </message>
    <message>
        <source>Pictures turned and moved by hand: number of the picture, degrees clockwise, percent to the right and percent down, such as 3:1.5,2,-0.5.</source>
        <translation>Von Hand gedrehte und verschobene Bilder: Nummer des Bildes, Grad im Uhrzeigersinn, Prozent nach rechts und Prozent nach unten, etwa 3:1.5,2,-0.5.</translation>
    </message>
    <message>
        <source>Pictures…</source>
        <translation>Bilder…</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Pitch</translation>
    </message>
    <message>
        <source>Pitch error</source>
        <extracomment>tables</extracomment>
        <translation>Fehler des Streifenabstands</translation>
    </message>
    <message>
        <source>Pitch finds the LPI that printer and sheet agree on; phase where the strips lie; views how many can be told apart; rotation whether the sheet is straight.</source>
        <translation>„Pitch“ findet den LPI-Wert, auf den sich Drucker und Folie einigen; „Phase“, wo die Streifen liegen; „Ansichten“, wie viele sich unterscheiden lassen; „Drehung“, ob die Folie gerade liegt.</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>Pixel %1, %2: setting %3; reference %4; error %5</source>
        <translation>Pixel %1, %2: Einstellung %3; Referenz %4; Fehler %5</translation>
    </message>
    <message>
        <source>Pixel Art</source>
        <translation>Pixel-Art</translation>
    </message>
    <message>
        <source>pixel samples</source>
        <translation>Pixel-Samples</translation>
    </message>
    <message>
        <source>pixel_art, which has one animation</source>
        <translation>pixel_art, das nur eine Animation hat</translation>
    </message>
    <message>
        <source>Pixels</source>
        <extracomment>tables</extracomment>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Pixels across a rendered view; more than two for each lens are lost.</source>
        <translation>Pixel quer über eine gerenderte Ansicht; mehr als zwei pro Linse gehen verloren.</translation>
    </message>
    <message>
        <source>pixels in a row</source>
        <translation>Pixel in einer Zeile</translation>
    </message>
    <message>
        <source>Pixels per lens</source>
        <translation>Pixel pro Linse</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Platz %1</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>places each lantern on the water at this time</source>
        <translation>setzt jede Laterne auf das Wasser dieses Zeitpunkts</translation>
    </message>
    <message>
        <source>plain</source>
        <extracomment>tables</extracomment>
        <translation>einfach</translation>
    </message>
    <message>
        <source>plain sum</source>
        <extracomment>tables</extracomment>
        <translation>einfache Summe</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>Pflanze</translation>
    </message>
    <message>
        <source>plaque free</source>
        <translation>Schild frei</translation>
    </message>
    <message>
        <source>plaque {1}</source>
        <translation>Schild {1}</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plinth</source>
        <extracomment>tables</extracomment>
        <translation>Sockel</translation>
    </message>
    <message>
        <source>Plinth color</source>
        <extracomment>tables</extracomment>
        <translation>Sockelfarbe</translation>
    </message>
    <message>
        <source>Plinth roughness</source>
        <extracomment>tables</extracomment>
        <translation>Sockelrauheit</translation>
    </message>
    <message>
        <source>Plus and minus zoom, 0 fits, 1 shows pixel for pixel, arrows move, Ctrl with an arrow moves the line of the wipe.</source>
        <translation>Plus und Minus zoomen, 0 passt ein, 1 zeigt Pixel für Pixel, Pfeiltasten verschieben, Strg mit einer Pfeiltaste bewegt die Linie der Wischblende.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Point in the middle of the picture.</source>
        <translation>Punkt in der Mitte des Bildes.</translation>
    </message>
    <message>
        <source>Point size</source>
        <extracomment>tables</extracomment>
        <translation>Punktgröße</translation>
    </message>
    <message>
        <source>Point that the description gives: the object's origin, the middle of the frame, or the middle of its lower edge.</source>
        <translation>Punkt, den die Beschreibung angibt: der Ursprung des Objekts, die Mitte des Bildes oder die Mitte seiner Unterkante.</translation>
    </message>
    <message>
        <source>polar sum</source>
        <extracomment>tables</extracomment>
        <translation>Polarsumme</translation>
    </message>
    <message>
        <source>Poodle</source>
        <translation>Pudel</translation>
    </message>
    <message>
        <source>Porcelain mug</source>
        <translation>Porzellanbecher</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position along the strand where the color changes from root to tip: low near the root, high near the tip.</source>
        <extracomment>tables</extracomment>
        <translation>Stelle am Haar, an der die Farbe von der Wurzel zur Spitze wechselt: niedrige Werte nahe der Wurzel, hohe nahe der Spitze.</translation>
    </message>
    <message>
        <source>position and target are the same point; move one of them</source>
        <translation>Position und Ziel sind derselbe Punkt; verschieben Sie einen davon</translation>
    </message>
    <message>
        <source>Position between the children: 0 is the first, 1 is the second.</source>
        <translation>Lage zwischen den Kindern: 0 ist das erste, 1 das zweite.</translation>
    </message>
    <message>
        <source>Position of the boundary between the halves: 0 is the left edge of the opening, 1 the right.</source>
        <extracomment>tables</extracomment>
        <translation>Lage der Grenze zwischen den Hälften: 0 ist der linke Rand der Öffnung, 1 der rechte.</translation>
    </message>
    <message>
        <source>Position of the boundary between the halves: 0 is the left edge, 1 the right.</source>
        <extracomment>tables</extracomment>
        <translation>Lage der Grenze zwischen den Hälften: 0 ist der linke Rand, 1 der rechte.</translation>
    </message>
    <message>
        <source>Position of the candy across, from the axis.</source>
        <extracomment>tables</extracomment>
        <translation>Lage des Bonbons quer, von der Achse aus.</translation>
    </message>
    <message>
        <source>Position of the candy towards the front, from the axis.</source>
        <extracomment>tables</extracomment>
        <translation>Lage des Bonbons nach vorn, von der Achse aus.</translation>
    </message>
    <message>
        <source>Position of the center of the light.</source>
        <translation>Position der Mitte des Lichts.</translation>
    </message>
    <message>
        <source>Position of the cones' bases across, from the axis.</source>
        <extracomment>tables</extracomment>
        <translation>Lage der Grundflächen der Kegel quer, von der Achse aus.</translation>
    </message>
    <message>
        <source>Position of the cones' bases towards the front, from the axis.</source>
        <extracomment>tables</extracomment>
        <translation>Lage der Grundflächen der Kegel nach vorn, von der Achse aus.</translation>
    </message>
    <message>
        <source>Position of the eye.</source>
        <translation>Position des Auges.</translation>
    </message>
    <message>
        <source>Position of the first corner.</source>
        <translation>Position der ersten Ecke.</translation>
    </message>
    <message>
        <source>Position of the first end.</source>
        <translation>Position des ersten Endes.</translation>
    </message>
    <message>
        <source>Position of the fourth corner.</source>
        <translation>Position der vierten Ecke.</translation>
    </message>
    <message>
        <source>Position of the light.</source>
        <translation>Position des Lichts.</translation>
    </message>
    <message>
        <source>Position of the object from the hall's middle towards the entrance; walls and furniture limit it.</source>
        <extracomment>tables</extracomment>
        <translation>Position des Objekts von der Hallenmitte zum Eingang hin; Wände und Möbel begrenzen sie.</translation>
    </message>
    <message>
        <source>Position of the object to the right of the hall's middle, seen from the entrance; walls and furniture limit it.</source>
        <extracomment>tables</extracomment>
        <translation>Position des Objekts rechts der Hallenmitte, vom Eingang aus gesehen; Wände und Möbel begrenzen sie.</translation>
    </message>
    <message>
        <source>Position of the second corner.</source>
        <translation>Position der zweiten Ecke.</translation>
    </message>
    <message>
        <source>Position of the second end.</source>
        <translation>Position des zweiten Endes.</translation>
    </message>
    <message>
        <source>Position of the third corner.</source>
        <translation>Position der dritten Ecke.</translation>
    </message>
    <message>
        <source>Post wire</source>
        <extracomment>tables</extracomment>
        <translation>Pfostendraht</translation>
    </message>
    <message>
        <source>Pre&amp;vious panel</source>
        <translation>V&amp;origes Bedienfeld</translation>
    </message>
    <message>
        <source>Precision of the depth buffer: 16 bits make visible errors in normals.</source>
        <extracomment>tables</extracomment>
        <translation>Genauigkeit des Tiefenpuffers: 16 Bit machen sichtbare Fehler in Normalen.</translation>
    </message>
    <message>
        <source>Prefere&amp;nces…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Prefilter</source>
        <extracomment>tables</extracomment>
        <translation>Vorfilter</translation>
    </message>
    <message>
        <source>Present: %1, error %2, cost %3.</source>
        <translation>Jetzt: %1, Fehler %2, Kosten %3.</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>Preset: %1</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Presets</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Presets (*.json)</translation>
    </message>
    <message>
        <source>Presets, and pictures with one inside (%1)</source>
        <translation>Presets und Bilder mit eingebettetem Preset (%1)</translation>
    </message>
    <message>
        <source>Press the button of %1</source>
        <translation>Den Knopf von %1 drücken</translation>
    </message>
    <message>
        <source>Press the new shortcut of the command.</source>
        <translation>Drücken Sie das neue Tastenkürzel des Befehls.</translation>
    </message>
    <message>
        <source>Press the red button</source>
        <translation>Den roten Knopf drücken</translation>
    </message>
    <message>
        <source>Press the red button you look at, or that of the exhibit you visit</source>
        <translation>Den roten Knopf drücken, den Sie ansehen, oder den des besuchten Exponats</translation>
    </message>
    <message>
        <source>Presses the red button of the exhibit in front of you; E does the same while the picture has the focus.</source>
        <translation>Drückt den roten Knopf des Exponats vor Ihnen; E tut dasselbe, während das Bild den Fokus hat.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Preview of a preset</source>
        <translation>Vorschau eines Presets</translation>
    </message>
    <message>
        <source>Primitives</source>
        <translation>Grundformen</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Print that `vitrine print` wrote; of a print in tiles, any of them.</source>
        <translation>Druck, den `vitrine print` geschrieben hat; bei einem Druck in Kacheln eine beliebige davon.</translation>
    </message>
    <message>
        <source>Print that the card shows while it does not scroll.</source>
        <extracomment>tables</extracomment>
        <translation>Druck, den die Karte zeigt, solange sie nicht rollt.</translation>
    </message>
    <message>
        <source>Printed dots per inch: the native resolution of the printer or a whole fraction of it.</source>
        <translation>Gedruckte Punkte pro Zoll: die native Auflösung des Druckers oder ein ganzer Bruchteil davon.</translation>
    </message>
    <message>
        <source>Printed dots that one lens covers: no more views than these can be told apart.</source>
        <translation>Druckpunkte, die eine Linse überdeckt: mehr Ansichten lassen sich nicht unterscheiden.</translation>
    </message>
    <message>
        <source>Printed raster</source>
        <translation>Gedrucktes Raster</translation>
    </message>
    <message>
        <source>Printing</source>
        <extracomment>tables</extracomment>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Prints</source>
        <extracomment>tables</extracomment>
        <translation>Drucke</translation>
    </message>
    <message>
        <source>Prints (%1)</source>
        <translation>Drucke (%1)</translation>
    </message>
    <message>
        <source>probe</source>
        <extracomment>tables</extracomment>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Probe samples</source>
        <extracomment>tables</extracomment>
        <translation>Sonden-Samples</translation>
    </message>
    <message>
        <source>Probe size</source>
        <extracomment>tables</extracomment>
        <translation>Sondengröße</translation>
    </message>
    <message>
        <source>process CPU time around glFinish</source>
        <translation>CPU-Zeit des Prozesses um glFinish</translation>
    </message>
    <message>
        <source>Profile of the blend between the surfaces.</source>
        <translation>Profil der Verschmelzung zwischen den Oberflächen.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Projection</source>
        <extracomment>tables</extracomment>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Projection of the camera: orthographic, which is usual for pixel art, or perspective, in which distance makes things smaller.</source>
        <extracomment>tables</extracomment>
        <translation>Projektion der Kamera: orthografisch, wie bei Pixel-Art üblich, oder perspektivisch, bei der Entfernung Dinge kleiner macht.</translation>
    </message>
    <message>
        <source>Proof of a print</source>
        <translation>Ansicht eines Drucks</translation>
    </message>
    <message>
        <source>Put %1 into the hall</source>
        <translation>%1 in die Halle stellen</translation>
    </message>
    <message>
        <source>Quadratic</source>
        <translation>Quadratisch</translation>
    </message>
    <message>
        <source>Quantity by which the object is colored: the steps or evaluations that it cost, its normals, or its distance.</source>
        <extracomment>tables</extracomment>
        <translation>Größe, nach der das Objekt gefärbt wird: die Schritte oder Auswertungen, die es gekostet hat, seine Normalen oder sein Abstand.</translation>
    </message>
    <message>
        <source>Quantity by which the scene is colored: the steps, evaluations or shape evaluations that it cost, or its normals.</source>
        <extracomment>tables</extracomment>
        <translation>Größe, nach der die Szene gefärbt wird: die Schritte, Auswertungen oder Formauswertungen, die sie gekostet hat, oder ihre Normalen.</translation>
    </message>
    <message>
        <source>Quantity on the lower axis of the chart: time, or counted work, which is the same on every machine.</source>
        <translation>Größe auf der unteren Achse des Diagramms: Zeit oder gezählte Arbeit, die auf jedem Rechner gleich ist.</translation>
    </message>
    <message>
        <source>quarter</source>
        <extracomment>tables</extracomment>
        <translation>Viertel</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Quilt</source>
        <translation>Quilt</translation>
    </message>
    <message>
        <source>quilt</source>
        <translation>Quilt</translation>
    </message>
    <message>
        <source>Quilt columns</source>
        <translation>Quilt-Spalten</translation>
    </message>
    <message>
        <source>Quilt rows</source>
        <translation>Quilt-Zeilen</translation>
    </message>
    <message>
        <source>Radiance of the light, as linear values.</source>
        <translation>Strahldichte des Lichts, in linearen Werten.</translation>
    </message>
    <message>
        <source>Radii</source>
        <translation>Radien</translation>
    </message>
    <message>
        <source>Radii along x, y and z.</source>
        <translation>Radien entlang x, y und z.</translation>
    </message>
    <message>
        <source>Radius</source>
        <extracomment>tables</extracomment>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius around the segment.</source>
        <translation>Radius um die Strecke.</translation>
    </message>
    <message>
        <source>Radius at the end.</source>
        <translation>Radius am Ende.</translation>
    </message>
    <message>
        <source>Radius at the lower end.</source>
        <translation>Radius am unteren Ende.</translation>
    </message>
    <message>
        <source>Radius at the start.</source>
        <translation>Radius am Anfang.</translation>
    </message>
    <message>
        <source>Radius at the upper end.</source>
        <translation>Radius am oberen Ende.</translation>
    </message>
    <message>
        <source>Radius by which the child grows.</source>
        <translation>Radius, um den das Kind wächst.</translation>
    </message>
    <message>
        <source>Radius from the center to the middle of the tube.</source>
        <translation>Radius vom Mittelpunkt bis zur Mitte des Rohrs.</translation>
    </message>
    <message>
        <source>Radius in the middle; at most half the length.</source>
        <translation>Radius in der Mitte; höchstens die halbe Länge.</translation>
    </message>
    <message>
        <source>Radius of a cone at its base.</source>
        <extracomment>tables</extracomment>
        <translation>Radius eines Kegels an seiner Grundfläche.</translation>
    </message>
    <message>
        <source>Radius of curvature at the top of a custom lens; a radius too small for the lens pitch is enlarged to fit.</source>
        <extracomment>tables</extracomment>
        <translation>Krümmungsradius am Scheitel einer eigenen Linse; ein für den Linsenabstand zu kleiner wird passend vergrößert.</translation>
    </message>
    <message>
        <source>Radius of curvature at the top of the lenses.</source>
        <translation>Krümmungsradius am Scheitel der Linsen.</translation>
    </message>
    <message>
        <source>Radius of the base.</source>
        <translation>Radius der Grundfläche.</translation>
    </message>
    <message>
        <source>Radius of the bends, to the middle of the tube.</source>
        <translation>Radius der Bögen, bis zur Mitte des Rohrs.</translation>
    </message>
    <message>
        <source>Radius of the bowl at its bottom; at most that of its sphere.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Schale unten; höchstens der ihrer Kugel.</translation>
    </message>
    <message>
        <source>Radius of the bowl at its rim, between those of its bottom and of its sphere.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Schale am Rand, zwischen dem unten und dem ihrer Kugel.</translation>
    </message>
    <message>
        <source>Radius of the collar at its bottom.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Kragens unten.</translation>
    </message>
    <message>
        <source>Radius of the collar at its top.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Kragens oben.</translation>
    </message>
    <message>
        <source>Radius of the curls of a tuft, in strand lengths: 0 is straight.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Locken eines Büschels, in Haarlängen: 0 ist glatt.</translation>
    </message>
    <message>
        <source>Radius of the cutting sphere.</source>
        <translation>Radius der schneidenden Kugel.</translation>
    </message>
    <message>
        <source>Radius of the cylinder.</source>
        <translation>Radius des Zylinders.</translation>
    </message>
    <message>
        <source>Radius of the disk.</source>
        <translation>Radius der Scheibe.</translation>
    </message>
    <message>
        <source>Radius of the edges; at most half the smallest size.</source>
        <translation>Radius der Kanten; höchstens die halbe kleinste Größe.</translation>
    </message>
    <message>
        <source>Radius of the edges; at most the radius and half the height.</source>
        <translation>Radius der Kanten; höchstens der Radius und die halbe Höhe.</translation>
    </message>
    <message>
        <source>Radius of the foot at its bottom.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Fußes unten.</translation>
    </message>
    <message>
        <source>Radius of the foot at its top.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Fußes oben.</translation>
    </message>
    <message>
        <source>Radius of the handle, from its center to the middle of its tube.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Henkels, von seinem Mittelpunkt bis zur Mitte seines Rohrs.</translation>
    </message>
    <message>
        <source>Radius of the lower sphere.</source>
        <translation>Radius der unteren Kugel.</translation>
    </message>
    <message>
        <source>Radius of the outside of the mug.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Außenseite der Tasse.</translation>
    </message>
    <message>
        <source>Radius of the outside.</source>
        <translation>Radius der Außenseite.</translation>
    </message>
    <message>
        <source>Radius of the paper tube.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Papierröhre.</translation>
    </message>
    <message>
        <source>Radius of the posts.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Pfosten.</translation>
    </message>
    <message>
        <source>Radius of the round cross-section of the bars.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des runden Querschnitts der Stäbe.</translation>
    </message>
    <message>
        <source>Radius of the rounded edges of a cone; limited so that a cone is left.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der gerundeten Kanten eines Kegels; begrenzt, sodass ein Kegel bleibt.</translation>
    </message>
    <message>
        <source>Radius of the rounded edges of the candy; at most half its smallest side.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der gerundeten Kanten des Bonbons; höchstens die halbe kleinste Seite.</translation>
    </message>
    <message>
        <source>Radius of the scene's point lights: large gives soft shadows and wide highlights.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Punktlichter der Szene: Große geben weiche Schatten und breite Glanzlichter.</translation>
    </message>
    <message>
        <source>Radius of the sphere from which the bowl is cut.</source>
        <extracomment>tables</extracomment>
        <translation>Radius der Kugel, aus der die Schale geschnitten ist.</translation>
    </message>
    <message>
        <source>Radius of the sphere.</source>
        <translation>Radius der Kugel.</translation>
    </message>
    <message>
        <source>Radius of the torus, from its center to the middle of the tube.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Torus, vom Mittelpunkt bis zur Mitte des Rohrs.</translation>
    </message>
    <message>
        <source>Radius of the tube of the rings.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Rohrs der Ringe.</translation>
    </message>
    <message>
        <source>Radius of the tube of the torus.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Rohrs des Torus.</translation>
    </message>
    <message>
        <source>Radius of the tube.</source>
        <translation>Radius des Rohrs.</translation>
    </message>
    <message>
        <source>Radius of the upper sphere.</source>
        <translation>Radius der oberen Kugel.</translation>
    </message>
    <message>
        <source>Radius of the wire of the rings.</source>
        <extracomment>tables</extracomment>
        <translation>Radius des Drahts der Ringe.</translation>
    </message>
    <message>
        <source>Radius over which faceted normals are averaged, in texels, but not across edges: 0 keeps facets.</source>
        <extracomment>tables</extracomment>
        <translation>Radius, über den facettierte Normalen gemittelt werden, in Texeln, aber nicht über Kanten hinweg: 0 lässt Facetten.</translation>
    </message>
    <message>
        <source>Radius to the middle of the wall.</source>
        <translation>Radius bis zur Mitte der Wand.</translation>
    </message>
    <message>
        <source>Raise</source>
        <extracomment>tables</extracomment>
        <translation>Anheben</translation>
    </message>
    <message>
        <source>Random rotation of the lanterns: at 0 all face the same way.</source>
        <extracomment>tables</extracomment>
        <translation>Zufällige Drehung der Laternen: Bei 0 zeigen alle in dieselbe Richtung.</translation>
    </message>
    <message>
        <source>Random shift of the lanterns from the middle of their cells: 0 is a regular grid.</source>
        <extracomment>tables</extracomment>
        <translation>Zufällige Verschiebung der Laternen aus der Mitte ihrer Zellen: 0 ist ein regelmäßiges Gitter.</translation>
    </message>
    <message>
        <source>Randomi&amp;ze parameters</source>
        <translation>Parameter &amp;zufällig ändern</translation>
    </message>
    <message>
        <source>Randomize parameters, seed %1</source>
        <translation>Parameter zufällig ändern, Startwert %1</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>Bereich: %1</translation>
    </message>
    <message>
        <source>Range: %1. The value was set to %2.</source>
        <translation>Bereich: %1. Der Wert wurde auf %2 gesetzt.</translation>
    </message>
    <message>
        <source>raster</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Rate at which the ball grows and shrinks; 0 stops it.</source>
        <extracomment>tables</extracomment>
        <translation>Wie oft der Ball in der Sekunde wächst und schrumpft; 0 hält es an.</translation>
    </message>
    <message>
        <source>Rate at which the dust thins with height: 0 is even, high keeps it near the floor.</source>
        <extracomment>tables</extracomment>
        <translation>Wie schnell der Staub mit der Höhe dünner wird: 0 ist gleichmäßig, hohe Werte halten ihn am Boden.</translation>
    </message>
    <message>
        <source>Ray exposure</source>
        <extracomment>tables</extracomment>
        <translation>Strahlenbelichtung</translation>
    </message>
    <message>
        <source>Rays</source>
        <extracomment>tables</extracomment>
        <translation>Strahlen</translation>
    </message>
    <message>
        <source>Rays end before they have taken so many steps.</source>
        <translation>Strahlen enden, bevor sie so viele Schritte getan haben.</translation>
    </message>
    <message>
        <source>Rays have found the water in fewer steps.</source>
        <translation>Strahlen haben das Wasser in weniger Schritten gefunden.</translation>
    </message>
    <message>
        <source>rays use baked noise in empty space</source>
        <translation>Strahlen verwenden im leeren Raum gebackenes Rauschen</translation>
    </message>
    <message>
        <source>Read: %1 %2</source>
        <translation>Abzulesen: %1 %2</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Liest</translation>
    </message>
    <message>
        <source>Reading %1%2 … %3 s</source>
        <translation>Liest %1%2 … %3 s</translation>
    </message>
    <message>
        <source>Reading a preset …</source>
        <translation>Ein Preset wird gelesen …</translation>
    </message>
    <message>
        <source>reading it</source>
        <translation>das Lesen</translation>
    </message>
    <message>
        <source>reading it back</source>
        <translation>das Zurücklesen</translation>
    </message>
    <message>
        <source>reading it back failed ({1})</source>
        <translation>das Zurücklesen ist misslungen ({=1})</translation>
    </message>
    <message>
        <source>reading it back gave fewer bytes</source>
        <translation>das Zurücklesen ergab weniger Bytes, es</translation>
    </message>
    <message>
        <source>reading it back gave other bytes</source>
        <translation>das Zurücklesen ergab andere Bytes, es</translation>
    </message>
    <message>
        <source>reading it back gave other pixels</source>
        <translation>das Zurücklesen ergab andere Pixel</translation>
    </message>
    <message>
        <source>reading it back gave other pixels in row {1}</source>
        <translation>das Zurücklesen ergab andere Pixel in Zeile {1}</translation>
    </message>
    <message>
        <source>Reading the views was stopped; nothing was changed.</source>
        <translation>Das Lesen der Ansichten wurde angehalten; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Reading the views was stopped; nothing was written.</source>
        <translation>Das Lesen der Ansichten wurde angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>reading was canceled</source>
        <translation>das Lesen wurde abgebrochen</translation>
    </message>
    <message>
        <source>Reading, %1 %</source>
        <translation>Liest, %1 %</translation>
    </message>
    <message>
        <source>reads and writes pictures</source>
        <translation>liest und schreibt Bilder</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnete Dateien</translation>
    </message>
    <message>
        <source>Recor&amp;d…</source>
        <translation>&amp;Aufnehmen…</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Recording of {1}</source>
        <translation>Aufnahme von {1}</translation>
    </message>
    <message>
        <source>Records a video or frames: along bookmarks, around the current target, or as a tour of all exhibits.</source>
        <translation>Nimmt ein Video oder Frames auf: entlang von Lesezeichen, um das Betrachtete herum oder als Rundgang zu allen Exponaten.</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>Reduziert</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>reference</source>
        <extracomment>tables</extracomment>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Reference ambient</source>
        <extracomment>tables</extracomment>
        <translation>Umgebungslicht (Referenz)</translation>
    </message>
    <message>
        <source>Reference fog</source>
        <extracomment>tables</extracomment>
        <translation>Nebel (Referenz)</translation>
    </message>
    <message>
        <source>reference of {1}</source>
        <translation>Referenz von {1}</translation>
    </message>
    <message>
        <source>Reference sun</source>
        <extracomment>tables</extracomment>
        <translation>Sonne (Referenz)</translation>
    </message>
    <message>
        <source>Reference sun color</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenfarbe (Referenz)</translation>
    </message>
    <message>
        <source>Reference sun strength</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenstärke (Referenz)</translation>
    </message>
    <message>
        <source>Reference: ambient occlusion</source>
        <translation>Referenz: Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Reference: boxes</source>
        <translation>Referenz: Quader</translation>
    </message>
    <message>
        <source>Reference: clouds</source>
        <translation>Referenz: Wolken</translation>
    </message>
    <message>
        <source>Reference: environment mapping 1</source>
        <translation>Referenz: Umgebungsspiegelung 1</translation>
    </message>
    <message>
        <source>Reference: environment mapping 2</source>
        <translation>Referenz: Umgebungsspiegelung 2</translation>
    </message>
    <message>
        <source>Reference: field</source>
        <translation>Referenz: Feld</translation>
    </message>
    <message>
        <source>Reference: fractal noise</source>
        <translation>Referenz: fraktales Rauschen</translation>
    </message>
    <message>
        <source>Reference: fractal sum</source>
        <translation>Referenz: fraktale Summe</translation>
    </message>
    <message>
        <source>Reference: intersections</source>
        <translation>Referenz: Schnittmengen</translation>
    </message>
    <message>
        <source>Reference: noise</source>
        <translation>Referenz: Rauschen</translation>
    </message>
    <message>
        <source>Reference: primitives</source>
        <translation>Referenz: Grundformen</translation>
    </message>
    <message>
        <source>Reference: sea</source>
        <translation>Referenz: Meer</translation>
    </message>
    <message>
        <source>Reference: shading</source>
        <translation>Referenz: Schattierung</translation>
    </message>
    <message>
        <source>Reference: spheres, cylinders, capsules</source>
        <translation>Referenz: Kugeln, Zylinder, Kapseln</translation>
    </message>
    <message>
        <source>Reference: subtractions</source>
        <translation>Referenz: Differenzen</translation>
    </message>
    <message>
        <source>Reference: tori</source>
        <translation>Referenz: Tori</translation>
    </message>
    <message>
        <source>Reference: unions</source>
        <translation>Referenz: Vereinigungen</translation>
    </message>
    <message>
        <source>Reference: waves</source>
        <translation>Referenz: Wellen</translation>
    </message>
    <message>
        <source>Refining (%1 of %2 samples)</source>
        <translation>Verfeinert (%1 von %2 Samples)</translation>
    </message>
    <message>
        <source>Reflectance</source>
        <translation>Reflexionsgrad</translation>
    </message>
    <message>
        <source>Reflectance of nonmetals: 0 reflects nothing, 0.5 is the 4 % of most glazes.</source>
        <extracomment>tables</extracomment>
        <translation>Reflexionsgrad von Nichtmetallen: 0 spiegelt nichts, 0.5 sind die 4 % der meisten Glasuren.</translation>
    </message>
    <message>
        <source>Reflectance of nonmetals: 0.5 is 4 %.</source>
        <translation>Reflexionsgrad von Nichtmetallen: 0.5 sind 4 %.</translation>
    </message>
    <message>
        <source>Reflectance of the plastic: 0 is none, 0.5 is what its refractive index gives.</source>
        <extracomment>tables</extracomment>
        <translation>Reflexionsgrad des Kunststoffs: 0 ist keiner, 0.5 ist der aus seinem Brechungsindex.</translation>
    </message>
    <message>
        <source>Reflection probe</source>
        <extracomment>tables</extracomment>
        <translation>Reflexionssonde</translation>
    </message>
    <message>
        <source>Reflections</source>
        <extracomment>tables</extracomment>
        <translation>Spiegelungen</translation>
    </message>
    <message>
        <source>Reflections of the polished floor: the soft reflection probe alone, or with ray-traced shapes of the window, its bars and everything on the floor.</source>
        <extracomment>tables</extracomment>
        <translation>Spiegelungen des polierten Bodens: nur die weiche Reflexionssonde oder dazu, mit Strahlen gefunden, die Formen des Fensters, seiner Sprossen und alles auf dem Boden.</translation>
    </message>
    <message>
        <source>Refractive index</source>
        <extracomment>tables</extracomment>
        <translation>Brechungsindex</translation>
    </message>
    <message>
        <source>Refractive index of the custom sheet's plastic: 1.49 to 1.6 are usual.</source>
        <extracomment>tables</extracomment>
        <translation>Brechungsindex des Kunststoffs der eigenen Folie: 1.49 bis 1.6 sind üblich.</translation>
    </message>
    <message>
        <source>Refractive index of the glass.</source>
        <translation>Brechungsindex des Glases.</translation>
    </message>
    <message>
        <source>Refractive index of the glass: 1 bends nothing, 2.4 is diamond.</source>
        <extracomment>tables</extracomment>
        <translation>Brechungsindex des Glases: 1 bricht nichts, 2.4 ist Diamant.</translation>
    </message>
    <message>
        <source>Refractive index of the plastic: 1.49 acrylic, 1.57 PET, 1.59 polystyrene.</source>
        <translation>Brechungsindex des Kunststoffs: 1,49 Acryl, 1,57 PET, 1,59 Polystyrol.</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <extracomment>tables</extracomment>
        <translation>Relaxation</translation>
    </message>
    <message>
        <source>Relaxation factor</source>
        <extracomment>tables</extracomment>
        <translation>Relaxationsfaktor</translation>
    </message>
    <message>
        <source>Relaxation of the step length beyond the distance: none, by a fixed factor, or as far as the slope of the field allows.</source>
        <extracomment>tables</extracomment>
        <translation>Verlängerung der Schritte über die Distanz hinaus: keine, um einen festen Faktor oder so weit, wie die Steigung des Felds erlaubt.</translation>
    </message>
    <message>
        <source>Release</source>
        <extracomment>tables</extracomment>
        <translation>Freilassen</translation>
    </message>
    <message>
        <source>Relief blend</source>
        <extracomment>tables</extracomment>
        <translation>Reliefübergang</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove %1 from the hall</source>
        <translation>%1 aus der Halle entfernen</translation>
    </message>
    <message>
        <source>Removes all shortcuts of the command.</source>
        <translation>Entfernt alle Tastenkürzel des Befehls.</translation>
    </message>
    <message>
        <source>Removes the object from the hall; its file is kept.</source>
        <translation>Entfernt das Objekt aus der Halle; seine Datei bleibt.</translation>
    </message>
    <message>
        <source>Rename	F2</source>
        <translation>Umbenennen	F2</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Rename the study</source>
        <translation>Die Studie umbenennen</translation>
    </message>
    <message>
        <source>Rename, tags, duplicate, delete, import, export</source>
        <translation>Umbenennen, Tags, duplizieren, löschen, importieren, exportieren</translation>
    </message>
    <message>
        <source>Renames the selected preset.</source>
        <translation>Benennt das gewählte Preset um.</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Render again</source>
        <translation>Neu rendern</translation>
    </message>
    <message>
        <source>Rendering at %1 %</source>
        <translation>Rendert mit %1 %</translation>
    </message>
    <message>
        <source>Rendering the views was stopped; nothing was written.</source>
        <translation>Das Rendern der Ansichten wurde angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Rendering views, %1 %</source>
        <translation>Rendert Ansichten, %1 %</translation>
    </message>
    <message>
        <source>Renders the views once more, from where you stand now.</source>
        <translation>Rendert die Ansichten noch einmal, von dort, wo Sie jetzt stehen.</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>repeated</source>
        <extracomment>tables</extracomment>
        <translation>wiederholt</translation>
    </message>
    <message>
        <source>Repetition</source>
        <extracomment>tables</extracomment>
        <translation>Wiederholung</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Replace the file?</source>
        <translation>Die Datei ersetzen?</translation>
    </message>
    <message>
        <source>Replaces the operation by its only child.</source>
        <translation>Ersetzt die Operation durch ihr einziges Kind.</translation>
    </message>
    <message>
        <source>Representation of the object: the distance field, ray-marched, or a mesh of it, rasterized.</source>
        <extracomment>tables</extracomment>
        <translation>Darstellung des Objekts: das Distanzfeld, mit Strahlen abgeschritten, oder ein rasterisiertes Netz davon.</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Reset &amp;all parameters</source>
        <translation>&amp;Alle Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Reset to %1</source>
        <translation>Auf %1 zurücksetzen</translation>
    </message>
    <message>
        <source>Reset turn and shift of a view</source>
        <translation>Drehung und Verschiebung einer Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Reset turn and shift of the view</source>
        <translation>Drehung und Verschiebung der Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Resets all parameters in the panel to their initial values. Can be undone.</source>
        <translation>Setzt alle Parameter im Bedienfeld auf ihre Ausgangswerte. Lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Reshape</source>
        <translation>Umformen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Resolution at which the beams are computed; lower ones are upsampled with regard to depth.</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung, in der die Strahlen berechnet werden; niedrigere werden unter Beachtung der Tiefe hochskaliert.</translation>
    </message>
    <message>
        <source>Resolution in motion</source>
        <translation>Auflösung in Bewegung</translation>
    </message>
    <message>
        <source>Resolution of the drawn picture relative to the window, per side: below 1 is quicker and blurred.</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung des gezeichneten Bildes gegenüber dem Fenster, je Seite: Unter 1 ist es schneller und unschärfer.</translation>
    </message>
    <message>
        <source>Resolution of the picture while something moves: high is sharper, with fewer frames per second on a slow machine.</source>
        <translation>Auflösung des Bildes, während sich etwas bewegt: Hohe Werte sind schärfer, mit weniger Bildern pro Sekunde auf einem langsamen Rechner.</translation>
    </message>
    <message>
        <source>Resolution of the reflection probe, in texels per side of a face: low blurs polished surfaces.</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung der Reflexionssonde, in Texeln je Seite einer Fläche: Niedrige Werte machen polierte Oberflächen unscharf.</translation>
    </message>
    <message>
        <source>Resolution of the small picture in pixels.</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung des kleinen Bildes in Pixeln.</translation>
    </message>
    <message>
        <source>Resolution of the sun's shadow map, in texels per side: low gives coarse shadow edges.</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung der Shadow-Map der Sonne, in Texeln je Seite: Niedrige Werte geben grobe Schattenränder.</translation>
    </message>
    <message>
        <source>Resolution of the volume into which noise is baked, in texels per side: low loses detail.</source>
        <extracomment>tables</extracomment>
        <translation>Auflösung des Volumens, in das Rauschen gebacken wird, in Texeln je Seite: Niedrige Werte verlieren Details.</translation>
    </message>
    <message>
        <source>Resolution scale</source>
        <extracomment>tables</extracomment>
        <translation>Auflösungsmaßstab</translation>
    </message>
    <message>
        <source>Restores the default shortcuts of all commands.</source>
        <translation>Stellt die üblichen Tastenkürzel aller Befehle wieder her.</translation>
    </message>
    <message>
        <source>Restores the default shortcuts of the command.</source>
        <translation>Stellt die üblichen Tastenkürzel des Befehls wieder her.</translation>
    </message>
    <message>
        <source>Return to where you stood before</source>
        <translation>Zurück dorthin, wo Sie vorher standen</translation>
    </message>
    <message>
        <source>Returns to the entrance of the hall.</source>
        <translation>Führt zurück zum Eingang der Halle.</translation>
    </message>
    <message>
        <source>Returns to where you stood before; Backspace does the same while the picture has the focus.</source>
        <translation>Führt dorthin zurück, wo Sie vorher standen; die Rücktaste tut dasselbe, während das Bild den Fokus hat.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <extracomment>tables</extracomment>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>reversed</source>
        <extracomment>tables</extracomment>
        <translation>umgekehrt</translation>
    </message>
    <message>
        <source>Reverses the direction in which dragging up or down turns the view.</source>
        <translation>Kehrt um, wohin Ziehen nach oben oder unten den Blick dreht.</translation>
    </message>
    <message>
        <source>Rib stretch</source>
        <extracomment>tables</extracomment>
        <translation>Rippenstreckung</translation>
    </message>
    <message>
        <source>Rib width</source>
        <extracomment>tables</extracomment>
        <translation>Rippenbreite</translation>
    </message>
    <message>
        <source>Ride</source>
        <extracomment>tables</extracomment>
        <translation>Schwimmbewegung</translation>
    </message>
    <message>
        <source>ridged</source>
        <extracomment>tables</extracomment>
        <translation>gratig</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Right bounces</source>
        <extracomment>tables</extracomment>
        <translation>Spiegelungen rechts</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>Rechts ziehen</translation>
    </message>
    <message>
        <source>Right evaluation</source>
        <extracomment>tables</extracomment>
        <translation>Auswertung rechts</translation>
    </message>
    <message>
        <source>Right eye</source>
        <translation>Rechtes Auge</translation>
    </message>
    <message>
        <source>Right hit tolerance</source>
        <extracomment>tables</extracomment>
        <translation>Treffertoleranz rechts</translation>
    </message>
    <message>
        <source>Right method</source>
        <extracomment>tables</extracomment>
        <translation>Verfahren rechts</translation>
    </message>
    <message>
        <source>Right occlusion method</source>
        <extracomment>tables</extracomment>
        <translation>Verdeckung rechts</translation>
    </message>
    <message>
        <source>Right shadow method</source>
        <extracomment>tables</extracomment>
        <translation>Schatten rechts</translation>
    </message>
    <message>
        <source>Right step limit</source>
        <extracomment>tables</extracomment>
        <translation>Schrittgrenze rechts</translation>
    </message>
    <message>
        <source>Right stick</source>
        <translation>Rechter Stick</translation>
    </message>
    <message>
        <source>Right view</source>
        <extracomment>tables</extracomment>
        <translation>Ansicht rechts</translation>
    </message>
    <message>
        <source>Rim light</source>
        <extracomment>tables</extracomment>
        <translation>Randlicht</translation>
    </message>
    <message>
        <source>Ring density</source>
        <extracomment>tables</extracomment>
        <translation>Ring: Dichte</translation>
    </message>
    <message>
        <source>Ring length</source>
        <extracomment>tables</extracomment>
        <translation>Ring: Länge</translation>
    </message>
    <message>
        <source>Ring model</source>
        <extracomment>tables</extracomment>
        <translation>Ringmodell</translation>
    </message>
    <message>
        <source>Ring root</source>
        <extracomment>tables</extracomment>
        <translation>Ring: Wurzel</translation>
    </message>
    <message>
        <source>Ring thickness</source>
        <extracomment>tables</extracomment>
        <translation>Ring: Dicke</translation>
    </message>
    <message>
        <source>Ring tip</source>
        <extracomment>tables</extracomment>
        <translation>Ring: Spitze</translation>
    </message>
    <message>
        <source>Ring tube</source>
        <extracomment>tables</extracomment>
        <translation>Ringrohr</translation>
    </message>
    <message>
        <source>Ring uniformity</source>
        <extracomment>tables</extracomment>
        <translation>Ring: Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>Ring wire</source>
        <extracomment>tables</extracomment>
        <translation>Ringdraht</translation>
    </message>
    <message>
        <source>Rings</source>
        <extracomment>tables</extracomment>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>rings</source>
        <extracomment>tables</extracomment>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>Ripple count</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Kräuselwellen</translation>
    </message>
    <message>
        <source>Ripples</source>
        <extracomment>tables</extracomment>
        <translation>Kräuselung</translation>
    </message>
    <message>
        <source>rises</source>
        <extracomment>tables</extracomment>
        <translation>steigt</translation>
    </message>
    <message>
        <source>RMS distance of surfaces, meters</source>
        <translation>RMS-Abstand der Oberflächen, Meter</translation>
    </message>
    <message>
        <source>RMS error of linear light</source>
        <translation>RMS-Fehler des linearen Lichts</translation>
    </message>
    <message>
        <source>Roll density</source>
        <extracomment>tables</extracomment>
        <translation>Rolle: Dichte</translation>
    </message>
    <message>
        <source>Roll length</source>
        <extracomment>tables</extracomment>
        <translation>Rolle: Länge</translation>
    </message>
    <message>
        <source>Roll root</source>
        <extracomment>tables</extracomment>
        <translation>Rolle: Wurzel</translation>
    </message>
    <message>
        <source>Roll thickness</source>
        <extracomment>tables</extracomment>
        <translation>Rolle: Dicke</translation>
    </message>
    <message>
        <source>Roll tip</source>
        <extracomment>tables</extracomment>
        <translation>Rolle: Spitze</translation>
    </message>
    <message>
        <source>Roll uniformity</source>
        <extracomment>tables</extracomment>
        <translation>Rolle: Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>Root</source>
        <extracomment>tables</extracomment>
        <translation>Wurzel</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rotation about the y axis.</source>
        <translation>Drehung um die y-Achse.</translation>
    </message>
    <message>
        <source>Rotation limit</source>
        <extracomment>tables</extracomment>
        <translation>Drehgrenze</translation>
    </message>
    <message>
        <source>Rotation model</source>
        <extracomment>tables</extracomment>
        <translation>Drehmodell</translation>
    </message>
    <message>
        <source>Rotation of the ice cream about its axis.</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Eises um seine Achse.</translation>
    </message>
    <message>
        <source>Rotation of the mobile about its axis.</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Mobiles um seine Achse.</translation>
    </message>
    <message>
        <source>Rotation of the object about the vertical axis.</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Objekts um die senkrechte Achse.</translation>
    </message>
    <message>
        <source>Rotation of the panorama about the vertical axis.</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Panoramas um die senkrechte Achse.</translation>
    </message>
    <message>
        <source>Rotation of the print against the sheet: even a little makes fringes lean across the card.</source>
        <extracomment>tables</extracomment>
        <translation>Drehung des Drucks gegen die Folie: Schon wenig lässt Streifenmuster schräg über die Karte laufen.</translation>
    </message>
    <message>
        <source>Rotation of the shape about z, then y, then x.</source>
        <translation>Drehung der Form um z, dann y, dann x.</translation>
    </message>
    <message>
        <source>Rotation of the tips about the axis towards the entrance, when set by hand.</source>
        <extracomment>tables</extracomment>
        <translation>Drehung der Spitzen um die Achse zum Eingang hin, wenn sie von Hand gesetzt wird.</translation>
    </message>
    <message>
        <source>Rotunda</source>
        <translation>Rotunde</translation>
    </message>
    <message>
        <source>rough glass shows what is behind it</source>
        <translation>raues Glas zeigt, was hinter ihm liegt</translation>
    </message>
    <message>
        <source>Roughness</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Roughness of candies and sprinkles: 0 is a mirror, 1 is chalk.</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit der Bonbons und Streusel: 0 ist ein Spiegel, 1 ist Kreide.</translation>
    </message>
    <message>
        <source>Roughness of the cream: low looks melting, high dry.</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit des Eises: Niedrige Werte wirken schmelzend, hohe trocken.</translation>
    </message>
    <message>
        <source>Roughness of the plastic: low looks wet, high is matte.</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit des Kunststoffs: Niedrige Werte wirken nass, hohe matt.</translation>
    </message>
    <message>
        <source>Roughness of the plinth: 0 is a mirror, 1 is chalk.</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit des Sockels: 0 ist ein Spiegel, 1 ist Kreide.</translation>
    </message>
    <message>
        <source>Roughness of the surface: 0 is a mirror, 1 is chalk.</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit der Oberfläche: 0 ist ein Spiegel, 1 ist Kreide.</translation>
    </message>
    <message>
        <source>Roughness of the wafer: 0 is a mirror, 1 is chalk.</source>
        <extracomment>tables</extracomment>
        <translation>Rauheit der Waffel: 0 ist ein Spiegel, 1 ist Kreide.</translation>
    </message>
    <message>
        <source>round edges</source>
        <extracomment>tables</extracomment>
        <translation>runde Kanten</translation>
    </message>
    <message>
        <source>Round what you look at</source>
        <translation>Um das Betrachtete herum</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Rows</source>
        <extracomment>tables</extracomment>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Rows of views in a quilt, the first at the bottom.</source>
        <translation>Zeilen von Ansichten in einem Quilt, die erste unten.</translation>
    </message>
    <message>
        <source>Rows: %1</source>
        <translation>Zeilen: %1</translation>
    </message>
    <message>
        <source>Run everything</source>
        <translation>Alles ausführen</translation>
    </message>
    <message>
        <source>run {1} of {2}</source>
        <translation>Durchlauf {1} von {2}</translation>
    </message>
    <message>
        <source>Runs every pass, including those that the picture does not need. The picture stays identical; only the cost changes.</source>
        <translation>Führt jeden Pass aus, auch die, die das Bild nicht braucht. Das Bild bleibt auf das Bit gleich; nur die Kosten ändern sich.</translation>
    </message>
    <message>
        <source>Runs the measurements of the visited exhibit, such as the methods of the pixel art, and saves them as CSV.</source>
        <translation>Führt die Messungen des besuchten Exponats aus, etwa die Verfahren der Pixel-Art, und speichert sie als CSV.</translation>
    </message>
    <message>
        <source>S&amp;trength</source>
        <translation>S&amp;tärke</translation>
    </message>
    <message>
        <source>Sa&amp;ve scene</source>
        <translation>Szene &amp;speichern</translation>
    </message>
    <message>
        <source>sample {1} of {2}</source>
        <translation>Sample {1} von {2}</translation>
    </message>
    <message>
        <source>Samples</source>
        <extracomment>tables</extracomment>
        <translation>Samples</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Samples</translation>
    </message>
    <message>
        <source>Samples at rest</source>
        <translation>Samples in Ruhe</translation>
    </message>
    <message>
        <source>Samples between</source>
        <extracomment>tables</extracomment>
        <translation>Samples dazwischen</translation>
    </message>
    <message>
        <source>samples kept</source>
        <translation>behaltene Samples</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Samples pro Pixel</translation>
    </message>
    <message>
        <source>Samples per pixel of a rendered view, each view with noise of its own.</source>
        <translation>Samples pro Pixel einer gerenderten Ansicht, jede Ansicht mit eigenem Rauschen.</translation>
    </message>
    <message>
        <source>Samples per pixel: edges are stairs at 1, smooth at 16.</source>
        <translation>Samples pro Pixel: Kanten sind bei 1 Treppen, bei 16 glatt.</translation>
    </message>
    <message>
        <source>Samples per pixel: edges are stairs at 1, smooth at 16; 64 is for prints.</source>
        <translation>Samples pro Pixel: Kanten sind bei 1 Treppen, bei 16 glatt; 64 sind für Drucke.</translation>
    </message>
    <message>
        <source>Saturation to the right, brightness upward; hue in the bar.
Arrows move in the field, with Ctrl in the bar.</source>
        <translation>Sättigung nach rechts, Helligkeit nach oben; Farbton im Balken.
Pfeiltasten bewegen im Feld, mit Strg im Balken.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save and close</source>
        <translation>Speichern und schließen</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Save as %1</source>
        <translation>Als %1 speichern</translation>
    </message>
    <message>
        <source>Save as a &amp;tour…</source>
        <translation>Als &amp;Rundgang speichern…</translation>
    </message>
    <message>
        <source>Save as a tour</source>
        <translation>Als Rundgang speichern</translation>
    </message>
    <message>
        <source>Save e&amp;xhibition…</source>
        <translation>Ausstellung s&amp;peichern…</translation>
    </message>
    <message>
        <source>Save exhibition</source>
        <translation>Ausstellung speichern</translation>
    </message>
    <message>
        <source>Save preset &amp;as…</source>
        <translation>Preset speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save preset of %1 as</source>
        <translation>Preset von %1 speichern unter</translation>
    </message>
    <message>
        <source>Save scene &amp;as…</source>
        <translation>Szene speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save settings</source>
        <translation>Einstellungen speichern</translation>
    </message>
    <message>
        <source>Save settings…</source>
        <translation>Einstellungen speichern…</translation>
    </message>
    <message>
        <source>Save sheet</source>
        <translation>Folie speichern</translation>
    </message>
    <message>
        <source>Save sheet %1</source>
        <translation>Folie %1 speichern</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messwerte speichern</translation>
    </message>
    <message>
        <source>Save the ticked…</source>
        <translation>Die angehakten speichern…</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespart</translation>
    </message>
    <message>
        <source>Saved %1 files, the first %2, and their settings beside them.</source>
        <translation>%1 Dateien gespeichert, die erste als %2, und daneben ihre Einstellungen.</translation>
    </message>
    <message>
        <source>Saved %1, and %2 files beside it.</source>
        <translation>%1 gespeichert, und daneben %2 Dateien.</translation>
    </message>
    <message>
        <source>Saved %1, and its settings beside it.</source>
        <translation>%1 gespeichert, und daneben die Einstellungen.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>In %1 gespeichert.</translation>
    </message>
    <message>
        <source>Saves everything in one file: all exhibits, the hall and where you stand.</source>
        <translation>Speichert alles in einer Datei: alle Exponate, die Halle und wo Sie stehen.</translation>
    </message>
    <message>
        <source>Saves the comparison as a table (CSV) or JSON, or the chart as PNG or SVG.</source>
        <translation>Speichert den Vergleich als Tabelle (CSV) oder JSON, oder das Diagramm als PNG oder SVG.</translation>
    </message>
    <message>
        <source>Saves the numbers below as a sheet of your own.</source>
        <translation>Speichert die Zahlen darunter als eigene Folie.</translation>
    </message>
    <message>
        <source>Saves the picture as PNG in your pictures folder.</source>
        <translation>Speichert das Bild als PNG in Ihrem Bilderordner.</translation>
    </message>
    <message>
        <source>Saves the picture at any size, as PNG, JPEG, EXR or TIFF.</source>
        <translation>Speichert das Bild in beliebiger Größe, als PNG, JPEG, EXR oder TIFF.</translation>
    </message>
    <message>
        <source>Saves the values that the panel shows to the preset in use.</source>
        <translation>Speichert die Werte, die das Bedienfeld zeigt, in das benutzte Preset.</translation>
    </message>
    <message>
        <source>Saves the values that the panel shows under a new name.</source>
        <translation>Speichert die Werte, die das Bedienfeld zeigt, unter einem neuen Namen.</translation>
    </message>
    <message>
        <source>Saves what was measured as a table (CSV) or JSON, or the chart as PNG or SVG.</source>
        <translation>Speichert das Gemessene als Tabelle (CSV) oder JSON, oder das Diagramm als PNG oder SVG.</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 skalieren</translation>
    </message>
    <message>
        <source>Scale of the lake, in meters of the lake per meter of the hall: high makes lanterns smaller.</source>
        <extracomment>tables</extracomment>
        <translation>Maßstab des Sees, in Metern des Sees je Meter der Halle: Hohe Werte machen Laternen kleiner.</translation>
    </message>
    <message>
        <source>Scale of the shape, one factor or one per axis; applied before rotation and translation.</source>
        <translation>Maßstab der Form, ein Faktor oder einer je Achse; vor Drehung und Verschiebung angewendet.</translation>
    </message>
    <message>
        <source>Scale of the whole motion of the fur: 0 keeps every strand upright, 1 is as simulated.</source>
        <extracomment>tables</extracomment>
        <translation>Maßstab der ganzen Bewegung des Fells: 0 lässt jedes Haar aufrecht, 1 zeigt sie wie simuliert.</translation>
    </message>
    <message>
        <source>Scatterings</source>
        <extracomment>tables</extracomment>
        <translation>Streuungen</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Scene file.</source>
        <translation>Szenendatei.</translation>
    </message>
    <message>
        <source>Scene parameters</source>
        <translation>Parameter der Szene</translation>
    </message>
    <message>
        <source>Screen space</source>
        <extracomment>tables</extracomment>
        <translation>Bildraum</translation>
    </message>
    <message>
        <source>screen space</source>
        <extracomment>tables</extracomment>
        <translation>Bildraum</translation>
    </message>
    <message>
        <source>Screen&amp;shot</source>
        <translation>Bildschirmf&amp;oto</translation>
    </message>
    <message>
        <source>Screenshot saved to %1.</source>
        <translation>Bildschirmfoto als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Scroll</source>
        <extracomment>tables</extracomment>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>SDF Scenes</source>
        <translation>SDF-Szenen</translation>
    </message>
    <message>
        <source>sea</source>
        <extracomment>tables</extracomment>
        <translation>Meer</translation>
    </message>
    <message>
        <source>Sea and wind</source>
        <extracomment>tables</extracomment>
        <translation>Meer und Wind</translation>
    </message>
    <message>
        <source>Sea steps</source>
        <extracomment>tables</extracomment>
        <translation>Meerschritte</translation>
    </message>
    <message>
        <source>Sea urchin</source>
        <translation>Seeigel</translation>
    </message>
    <message>
        <source>Second model</source>
        <extracomment>tables</extracomment>
        <translation>Modell 2</translation>
    </message>
    <message>
        <source>Second model across</source>
        <extracomment>tables</extracomment>
        <translation>Modell 2 quer</translation>
    </message>
    <message>
        <source>Second model along</source>
        <extracomment>tables</extracomment>
        <translation>Modell 2 längs</translation>
    </message>
    <message>
        <source>Second model plinth height</source>
        <extracomment>tables</extracomment>
        <translation>Sockelhöhe von Modell 2</translation>
    </message>
    <message>
        <source>Second model rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung von Modell 2</translation>
    </message>
    <message>
        <source>Second model size</source>
        <extracomment>tables</extracomment>
        <translation>Größe von Modell 2</translation>
    </message>
    <message>
        <source>Second model stand</source>
        <extracomment>tables</extracomment>
        <translation>Stand von Modell 2</translation>
    </message>
    <message>
        <source>Second object</source>
        <extracomment>tables</extracomment>
        <translation>Zweites Objekt</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Seed of lanterns and ripples: each number places them differently.</source>
        <extracomment>tables</extracomment>
        <translation>Startwert der Laternen und der Kräuselung: Jede Zahl verteilt sie anders.</translation>
    </message>
    <message>
        <source>Seed of the noise: each number gives another field, sea and sky.</source>
        <extracomment>tables</extracomment>
        <translation>Startwert des Rauschens: Jede Zahl gibt ein anderes Feld, ein anderes Meer und einen anderen Himmel.</translation>
    </message>
    <message>
        <source>Seed of the random directions and spins of a jump: the same number gives the same jump.</source>
        <extracomment>tables</extracomment>
        <translation>Startwert der zufälligen Richtungen und Drehungen eines Sprungs: Dieselbe Zahl gibt denselben Sprung.</translation>
    </message>
    <message>
        <source>Seed of the random rotation of the candy; 0 is upright.</source>
        <extracomment>tables</extracomment>
        <translation>Startwert der zufälligen Drehung des Bonbons; 0 ist aufrecht.</translation>
    </message>
    <message>
        <source>Seed of the sprinkles' places: each number places them elsewhere.</source>
        <extracomment>tables</extracomment>
        <translation>Startwert der Plätze der Streusel: Jede Zahl verteilt sie anders.</translation>
    </message>
    <message>
        <source>Seed of the variations: another number gives nine others, the same number the same ones.</source>
        <translation>Startwert der Variationen: Eine andere Zahl gibt neun andere, dieselbe dieselben.</translation>
    </message>
    <message>
        <source>Selected p&amp;reset as B</source>
        <translation>Gewähltes P&amp;reset als B</translation>
    </message>
    <message>
        <source>Self shadow</source>
        <extracomment>tables</extracomment>
        <translation>Selbstschatten</translation>
    </message>
    <message>
        <source>semi-implicit</source>
        <extracomment>tables</extracomment>
        <translation>semi-implizit</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>Set bookmark %1</source>
        <translation>Lesezeichen %1 setzen</translation>
    </message>
    <message>
        <source>Set bookmark %1 to this view</source>
        <translation>Lesezeichen %1 auf diese Ansicht setzen</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>von Hand gesetzt</translation>
    </message>
    <message>
        <source>Set sun by</source>
        <extracomment>tables</extracomment>
        <translation>Sonne nach</translation>
    </message>
    <message>
        <source>Set two bookmarks at least: one where you stand, then another elsewhere (Bookmarks menu).</source>
        <translation>Setzen Sie mindestens zwei Lesezeichen: eines, wo Sie stehen, dann ein anderes anderswo (Menü „Lesezeichen“).</translation>
    </message>
    <message>
        <source>Set what the study found</source>
        <translation>Ergebnis der Studie setzen</translation>
    </message>
    <message>
        <source>Sets all parameters in the panel to random values within their slider ranges, except files, accuracy and excluded parameters (see their menus). Can be undone.</source>
        <translation>Gibt allen Parametern im Bedienfeld zufällige Werte aus dem Bereich ihrer Regler, außer Dateien, Genauigkeit und ausgenommenen Parametern (siehe deren Menüs). Lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Sets B to a preset, an exhibition, or the settings inside a picture.</source>
        <translation>Setzt B auf ein Preset, eine Ausstellung oder die Einstellungen in einem Bild.</translation>
    </message>
    <message>
        <source>Sets B to the current values of all parameters; edit A further and compare.</source>
        <translation>Setzt B auf die jetzigen Werte aller Parameter; bearbeiten Sie A weiter und vergleichen Sie.</translation>
    </message>
    <message>
        <source>Sets B to the parameters before or after an edit.</source>
        <translation>Setzt B auf die Parameter vor oder nach einer Bearbeitung.</translation>
    </message>
    <message>
        <source>Sets B to the preset selected in the list.</source>
        <translation>Setzt B auf das in der Liste gewählte Preset.</translation>
    </message>
    <message>
        <source>Sets everything as in a settings document, or as beside a file that was exported.</source>
        <translation>Stellt alles so ein wie in einer Einstellungsdatei oder wie neben einer ausgegebenen Datei.</translation>
    </message>
    <message>
        <source>Sets this bookmark to the current view and replaces the old one.</source>
        <translation>Setzt dieses Lesezeichen auf die jetzige Ansicht und ersetzt die alte.</translation>
    </message>
    <message>
        <source>Sets turn and shift of this view to 0.</source>
        <translation>Setzt Drehung und Verschiebung dieser Ansicht auf 0.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Setting and reference in one place, with a line between them to drag</source>
        <translation>Einstellung und Referenz an einer Stelle, mit einer Linie dazwischen zum Ziehen</translation>
    </message>
    <message>
        <source>Setting of %1</source>
        <translation>Einstellung von %1</translation>
    </message>
    <message>
        <source>setting {1}, {2}</source>
        <translation>Einstellung {1}, {2}</translation>
    </message>
    <message>
        <source>Setting | reference</source>
        <translation>Einstellung | Referenz</translation>
    </message>
    <message>
        <source>Setting, reference and difference</source>
        <translation>Einstellung, Referenz und Unterschied</translation>
    </message>
    <message>
        <source>Settings (*.json)</source>
        <translation>Einstellungen (*.json)</translation>
    </message>
    <message>
        <source>Settings and prints (%1)</source>
        <translation>Einstellungen und Drucke (%1)</translation>
    </message>
    <message>
        <source>Settings of a job</source>
        <translation>Einstellungen eines Auftrags</translation>
    </message>
    <message>
        <source>Settings of jobs (*.vitrine-job.json)</source>
        <translation>Einstellungen von Aufträgen (*.vitrine-job.json)</translation>
    </message>
    <message>
        <source>Settings saved to %1.</source>
        <translation>Einstellungen in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Shade light</source>
        <extracomment>tables</extracomment>
        <translation>Himmelslicht</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Shading of the scene.</source>
        <translation>Beleuchtung der Szene.</translation>
    </message>
    <message>
        <source>Shading of the scene: as set in its file, physically based (metal, glaze and glass), or by Phong's formulas as in the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Beleuchtung der Szene: wie in ihrer Datei, physikalisch (Metall, Glasur und Glas) oder nach Phongs Formeln wie in der Referenz.</translation>
    </message>
    <message>
        <source>Shading of the work: physically based, or by the simpler formulas of the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Schattierung des Werks: physikalisch basiert oder nach den einfacheren Formeln der Referenz.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <extracomment>tables</extracomment>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Shadow filter</source>
        <extracomment>tables</extracomment>
        <translation>Schattenfilter</translation>
    </message>
    <message>
        <source>shadow k h / t</source>
        <extracomment>tables</extracomment>
        <translation>Schatten k h / t</translation>
    </message>
    <message>
        <source>Shadow map size</source>
        <extracomment>tables</extracomment>
        <translation>Shadow-Map-Größe</translation>
    </message>
    <message>
        <source>Shadow method</source>
        <extracomment>tables</extracomment>
        <translation>Schattenverfahren</translation>
    </message>
    <message>
        <source>Shadow method of the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Schattenverfahren der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Shadow rays</source>
        <extracomment>tables</extracomment>
        <translation>Schattenstrahlen</translation>
    </message>
    <message>
        <source>Shadows</source>
        <extracomment>tables</extracomment>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>shadows are off</source>
        <translation>Schatten sind aus</translation>
    </message>
    <message>
        <source>shadows are switched off</source>
        <translation>Schatten sind ausgeschaltet</translation>
    </message>
    <message>
        <source>Shape</source>
        <extracomment>tables</extracomment>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape between torus and mug: 0 is the torus, 1 is the mug.</source>
        <extracomment>tables</extracomment>
        <translation>Form zwischen Torus und Tasse: 0 ist der Torus, 1 ist die Tasse.</translation>
    </message>
    <message>
        <source>Shape of each octave before it is added: plain noise, sharp ridges, round lumps (billow), or its absolute value (turbulence).</source>
        <extracomment>tables</extracomment>
        <translation>Form jeder Oktave, bevor sie addiert wird: einfaches Rauschen, scharfe Grate, runde Klumpen (bauschig) oder ihr Betrag (Turbulenz).</translation>
    </message>
    <message>
        <source>Shape of the strands along their length: 0 tapers them to a needle, high keeps them thick with a blunt tip.</source>
        <extracomment>tables</extracomment>
        <translation>Form der Haare entlang ihrer Länge: 0 spitzt sie zu wie Nadeln, hohe Werte lassen sie dick mit stumpfer Spitze.</translation>
    </message>
    <message>
        <source>shapes</source>
        <extracomment>tables</extracomment>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Shapes that the shader evaluates at a point: those that matter there, from lists of cells, or all of them.</source>
        <extracomment>tables</extracomment>
        <translation>Formen, die der Shader an einem Punkt auswertet: die, auf die es dort ankommt, aus Listen von Zellen, oder alle.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Share of metal in all materials: 0 is edible, 1 is bare metal in their colors.</source>
        <extracomment>tables</extracomment>
        <translation>Metallanteil aller Materialien: 0 ist essbar, 1 ist blankes Metall in ihren Farben.</translation>
    </message>
    <message>
        <source>Share of metal: 0 is a glaze over a colored body, 1 is bare metal.</source>
        <extracomment>tables</extracomment>
        <translation>Metallanteil: 0 ist eine Glasur über einem farbigen Körper, 1 ist blankes Metall.</translation>
    </message>
    <message>
        <source>Share of metal: 0 is none, 1 is bare metal.</source>
        <translation>Metallanteil: 0 ist keiner, 1 ist blankes Metall.</translation>
    </message>
    <message>
        <source>share of pixels off by more than 1/255</source>
        <translation>Anteil der Pixel, die um mehr als 1/255 abweichen</translation>
    </message>
    <message>
        <source>Share of the bordering object's color in a dark line: 0 uses the outline color, 1 a dark tone of the object.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil der Farbe des angrenzenden Objekts an einer dunklen Linie: 0 nimmt die Umrissfarbe, 1 einen dunklen Ton des Objekts.</translation>
    </message>
    <message>
        <source>Share of the cells that hold a lantern: 0 is an empty lake, 1 fills every cell.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil der Zellen mit einer Laterne: 0 ist ein leerer See, 1 füllt jede Zelle.</translation>
    </message>
    <message>
        <source>Share of the color that is lit by the lights.</source>
        <translation>Anteil der Farbe, der von den Lichtern beleuchtet wird.</translation>
    </message>
    <message>
        <source>Share of the color that is lit from everywhere.</source>
        <translation>Anteil der Farbe, der von überall beleuchtet wird.</translation>
    </message>
    <message>
        <source>Share of the lenses' own slope that the highlight follows: 0 is a flat sheet, 1 spreads it in all directions across the lenses.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil der Steigung der Linsen, dem das Glanzlicht folgt: 0 ist eine flache Folie, 1 verteilt es quer zu den Linsen in alle Richtungen.</translation>
    </message>
    <message>
        <source>Share of the light that is left after each 128th of the way: 1 lets the sky reach everywhere, low keeps rays short.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil des Lichts, der nach jedem 128stel des Weges übrig ist: 1 lässt den Himmel überallhin reichen, niedrige Werte halten die Strahlen kurz.</translation>
    </message>
    <message>
        <source>Share of the light that is mirrored.</source>
        <translation>Anteil des Lichts, der gespiegelt wird.</translation>
    </message>
    <message>
        <source>Share of the light that reaches even the roots: 0 leaves them black, 1 removes the darkening.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil des Lichts, der sogar die Wurzeln erreicht: 0 lässt sie schwarz, 1 hebt die Abdunklung auf.</translation>
    </message>
    <message>
        <source>Share of the light that the clouds scatter backward, in a second lobe of the phase function.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil des Lichts, den die Wolken zurückstreuen, in einer zweiten Keule der Phasenfunktion.</translation>
    </message>
    <message>
        <source>Share of the period in which a print stays in place: low scrolls slowly, high scrolls quickly.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil der Periode, in dem ein Druck stehen bleibt: Niedrige Werte rollen langsam, hohe schnell.</translation>
    </message>
    <message>
        <source>Share of the sky that clouds cover: 0 is clear, 1 is overcast.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil des Himmels, den Wolken bedecken: 0 ist klar, 1 ist bedeckt.</translation>
    </message>
    <message>
        <source>Share of the slope and curvature bounds that sets the step length: 1 misses nothing, less is quicker but may miss details.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil der Schranken von Steigung und Krümmung, der die Schrittlänge bestimmt: 1 übergeht nichts, weniger ist schneller, kann aber Details übergehen.</translation>
    </message>
    <message>
        <source>share of the variance, cells</source>
        <translation>Anteil der Varianz, Zellen</translation>
    </message>
    <message>
        <source>Share of the way to the sun over which light is gathered: 0 shows only the mask, 1 gathers all the way.</source>
        <extracomment>tables</extracomment>
        <translation>Anteil des Weges zur Sonne, auf dem Licht gesammelt wird: 0 zeigt nur die Maske, 1 sammelt auf dem ganzen Weg.</translation>
    </message>
    <message>
        <source>sharp</source>
        <extracomment>tables</extracomment>
        <translation>scharf</translation>
    </message>
    <message>
        <source>Sharpness of the wave crests: 0 is a plain sum of sines, 1 is a sea, above 1 crests overturn.</source>
        <extracomment>tables</extracomment>
        <translation>Schärfe der Wellenkämme: 0 ist eine einfache Summe von Sinuswellen, 1 ein Meer, über 1 überschlagen sich Kämme.</translation>
    </message>
    <message>
        <source>Sheen</source>
        <extracomment>tables</extracomment>
        <translation>Samtglanz</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>sheet</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>Sheet kind</source>
        <extracomment>tables</extracomment>
        <translation>Folienart</translation>
    </message>
    <message>
        <source>Sheets to start from, and your own. Makers differ: measure yours with a pitch chart and save it.</source>
        <translation>Folien als Ausgangspunkt, und Ihre eigenen. Hersteller unterscheiden sich: Messen Sie Ihre mit einem Pitch-Testchart, und speichern Sie sie.</translation>
    </message>
    <message>
        <source>Shell count</source>
        <extracomment>tables</extracomment>
        <translation>Zahl der Shells</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Shift of the camera to the right.</source>
        <extracomment>tables</extracomment>
        <translation>Verschiebung der Kamera nach rechts.</translation>
    </message>
    <message>
        <source>Shift of the camera upwards.</source>
        <extracomment>tables</extracomment>
        <translation>Verschiebung der Kamera nach oben.</translation>
    </message>
    <message>
        <source>Shift of the noise through space.</source>
        <translation>Verschiebung des Rauschens durch den Raum.</translation>
    </message>
    <message>
        <source>Shift of the strips under the lenses, in lens widths.</source>
        <extracomment>tables</extracomment>
        <translation>Verschiebung der Streifen unter den Linsen, in Linsenbreiten.</translation>
    </message>
    <message>
        <source>Shift of the strips under the lenses, in lenses; a phase chart tells.</source>
        <translation>Verschiebung der Streifen unter den Linsen, in Linsen; ein Phasen-Testchart zeigt sie.</translation>
    </message>
    <message>
        <source>Shift of the view down</source>
        <translation>Verschiebung der Ansicht nach unten</translation>
    </message>
    <message>
        <source>Shift of the view to the right</source>
        <translation>Verschiebung der Ansicht nach rechts</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Shoulders</source>
        <translation>Schultertasten</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Show %1 alone</source>
        <translation>Nur %1 zeigen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Show all nodes</source>
        <translation>Alle Knoten zeigen</translation>
    </message>
    <message>
        <source>Show all of it (0)</source>
        <translation>Alles davon zeigen (0)</translation>
    </message>
    <message>
        <source>Show an interlaced print as it looks through its lens sheet, one pixel for each lens</source>
        <translation>Zeigt einen verschachtelten Druck, wie er durch seine Linsenfolie aussieht, ein Pixel je Linse</translation>
    </message>
    <message>
        <source>Show B a&amp;lone</source>
        <translation>Nur B &amp;zeigen</translation>
    </message>
    <message>
        <source>Show B instead of A</source>
        <translation>B statt A zeigen</translation>
    </message>
    <message>
        <source>Show box</source>
        <extracomment>tables</extracomment>
        <translation>Quader zeigen</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Show pixel for pixel (1)</source>
        <translation>Pixel für Pixel zeigen (1)</translation>
    </message>
    <message>
        <source>Show the &amp;answer</source>
        <translation>&amp;Antwort zeigen</translation>
    </message>
    <message>
        <source>Show the file in its folder</source>
        <translation>Die Datei in ihrem Ordner zeigen</translation>
    </message>
    <message>
        <source>Show the kept studies</source>
        <translation>Die aufbewahrten Studien zeigen</translation>
    </message>
    <message>
        <source>Show, rename, delete, copy, save</source>
        <translation>Zeigen, umbenennen, löschen, kopieren, speichern</translation>
    </message>
    <message>
        <source>Shown as</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigt als</translation>
    </message>
    <message>
        <source>shown instead of the field</source>
        <translation>anstelle des Felds gezeigt</translation>
    </message>
    <message>
        <source>Shows all nodes again.</source>
        <translation>Zeigt wieder alle Knoten.</translation>
    </message>
    <message>
        <source>Shows B instead of A. Holding the key B in the picture does the same.</source>
        <translation>Zeigt B statt A. Die Taste B im Bild zu halten, tut dasselbe.</translation>
    </message>
    <message>
        <source>Shows only commands whose name or shortcut contains these words.</source>
        <translation>Zeigt nur Befehle, deren Name oder Tastenkürzel diese Wörter enthält.</translation>
    </message>
    <message>
        <source>Shows only nodes whose name or kind contains these words. Enter goes to the first, Esc clears.</source>
        <translation>Zeigt nur Knoten, in deren Namen oder Art diese Wörter vorkommen. Die Eingabetaste geht zum ersten, Esc löscht die Wörter.</translation>
    </message>
    <message>
        <source>Shows only parameters whose name, group, help or choices contain these words. Enter goes to the first, Esc clears, Esc again leaves.</source>
        <translation>Zeigt nur Parameter, deren Name, Gruppe, Hilfe oder Auswahl diese Wörter enthält. Eingabe geht zum ersten, Esc leert das Feld, noch einmal Esc verlässt es.</translation>
    </message>
    <message>
        <source>Shows only parameters whose value is not the initial one.</source>
        <translation>Zeigt nur Parameter, deren Wert nicht der Ausgangswert ist.</translation>
    </message>
    <message>
        <source>Shows only presets whose name or tags contain these words, or which are “yours”. Enter loads the first, Esc clears.</source>
        <translation>Zeigt nur Presets, deren Name oder Tags diese Wörter enthalten, oder die „eigene“ sind. Eingabe lädt das erste, Esc leert das Feld.</translation>
    </message>
    <message>
        <source>Shows only this node and hides all others.</source>
        <translation>Zeigt nur diesen Knoten und blendet alle anderen aus.</translation>
    </message>
    <message>
        <source>Shows or hides the answer to the question of this step.</source>
        <translation>Zeigt oder verbirgt die Antwort auf die Frage dieses Schritts.</translation>
    </message>
    <message>
        <source>Shows or hides this panel.</source>
        <translation>Blendet dieses Bedienfeld ein oder aus.</translation>
    </message>
    <message>
        <source>Shows the differing parameters, and copies them from B to A.</source>
        <translation>Zeigt die verschiedenen Parameter und kopiert sie von B nach A.</translation>
    </message>
    <message>
        <source>Shows the fronts of the ticked studies over each other, and how they differ.</source>
        <translation>Zeigt die Fronten der angehakten Studien übereinander, und worin sie sich unterscheiden.</translation>
    </message>
    <message>
        <source>Shows the studies that were kept: to look at again, compare, rename, delete, open and save.</source>
        <translation>Zeigt die aufbewahrten Studien: zum Wiederansehen, Vergleichen, Umbenennen, Löschen, Öffnen und Speichern.</translation>
    </message>
    <message>
        <source>Side by &amp;side</source>
        <translation>&amp;Nebeneinander</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Side length of the wooden base.</source>
        <extracomment>tables</extracomment>
        <translation>Seitenlänge des hölzernen Bodens.</translation>
    </message>
    <message>
        <source>Sideways rotation of the cones, by which they lean past the axis.</source>
        <extracomment>tables</extracomment>
        <translation>Seitliche Drehung der Kegel, mit der sie an der Achse vorbei lehnen.</translation>
    </message>
    <message>
        <source>signed</source>
        <extracomment>tables</extracomment>
        <translation>vorzeichenbehaftet</translation>
    </message>
    <message>
        <source>Signed &amp;difference</source>
        <translation>Vorzeichenbehaftete &amp;Differenz</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <extracomment>tables</extracomment>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>silhouettes are not filled with fins</source>
        <translation>Silhouetten werden nicht mit Fins gefüllt</translation>
    </message>
    <message>
        <source>simplex</source>
        <extracomment>tables</extracomment>
        <translation>Simplex</translation>
    </message>
    <message>
        <source>Simulation</source>
        <extracomment>tables</extracomment>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>six faces</source>
        <translation>sechs Seiten</translation>
    </message>
    <message>
        <source>Sixteen fantasy colors</source>
        <translation>Sechzehn Fantasiefarben</translation>
    </message>
    <message>
        <source>Sixteen pictures in one print: the lenses choose, by where you stand.</source>
        <translation>Sechzehn Bilder in einem Druck: Die Linsen wählen, je nachdem, wo man steht.</translation>
    </message>
    <message>
        <source>Sixteen views</source>
        <translation>Sechzehn Ansichten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of a frame in pixels.</source>
        <translation>Größe eines Bildes in Pixeln.</translation>
    </message>
    <message>
        <source>Size of the bounding mesh in which rays march, relative to the smallest that holds the object: below 1 clips it.</source>
        <extracomment>tables</extracomment>
        <translation>Größe des Hüllnetzes, in dem Strahlen laufen, gegenüber dem kleinsten, das das Objekt umschließt: Unter 1 wird es beschnitten.</translation>
    </message>
    <message>
        <source>Size of the spot that a lens shows, relative to the model: 0 is one point of a strip, above 1 neighboring strips bleed in.</source>
        <extracomment>tables</extracomment>
        <translation>Größe des Flecks, den eine Linse zeigt, gegenüber dem Modell: 0 ist ein Punkt eines Streifens, über 1 dringen die Nachbarn ein.</translation>
    </message>
    <message>
        <source>Size of type</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Size relative to the reference, which is 1.4 m high.</source>
        <extracomment>tables</extracomment>
        <translation>Größe gegenüber der Referenz, die 1.4 m hoch ist.</translation>
    </message>
    <message>
        <source>skewed, from above</source>
        <translation>schräg, von oben</translation>
    </message>
    <message>
        <source>Skins are not supported; meshes keep their rest pose.</source>
        <translation>Skins werden nicht unterstützt; Netze behalten ihre Ruhepose.</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>Skipped cells</source>
        <translation>Übersprungene Zellen</translation>
    </message>
    <message>
        <source>Sky</source>
        <extracomment>tables</extracomment>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Sky color</source>
        <extracomment>tables</extracomment>
        <translation>Himmelsfarbe</translation>
    </message>
    <message>
        <source>Sky strength</source>
        <extracomment>tables</extracomment>
        <translation>Himmelsstärke</translation>
    </message>
    <message>
        <source>Sky temperature</source>
        <extracomment>tables</extracomment>
        <translation>Himmelstemperatur</translation>
    </message>
    <message>
        <source>slerp</source>
        <extracomment>tables</extracomment>
        <translation>slerp</translation>
    </message>
    <message>
        <source>Slices</source>
        <extracomment>tables</extracomment>
        <translation>Linsenzahl</translation>
    </message>
    <message>
        <source>Slope of the small waves that the wind makes: 0 is calm, high stretches reflections.</source>
        <extracomment>tables</extracomment>
        <translation>Steigung der kleinen Wellen, die der Wind macht: 0 ist ruhig, hohe Werte ziehen Spiegelungen in die Länge.</translation>
    </message>
    <message>
        <source>smooth layers</source>
        <extracomment>tables</extracomment>
        <translation>glatte Schichten</translation>
    </message>
    <message>
        <source>smooth wafer</source>
        <extracomment>tables</extracomment>
        <translation>glatte Waffel</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <extracomment>tables</extracomment>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>smoothing is 0</source>
        <translation>die Glättung ist 0</translation>
    </message>
    <message>
        <source>Snap</source>
        <extracomment>tables</extracomment>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Snapshot of A</source>
        <translation>Momentaufnahme von A</translation>
    </message>
    <message>
        <source>so many numbers take too long to be built into a program</source>
        <translation>so viele Zahlen brauchen zu lange, um in ein Programm gebaut zu werden</translation>
    </message>
    <message>
        <source>so many shapes blend into each other that cells would hold them all</source>
        <translation>so viele Formen gehen ineinander über, dass Zellen sie alle enthielten</translation>
    </message>
    <message>
        <source>Soft Serve</source>
        <translation>Softeis</translation>
    </message>
    <message>
        <source>Soft shadows</source>
        <translation>Weiche Schatten</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>some nodes are their own ancestors</source>
        <translation>einige Knoten sind ihre eigenen Vorfahren</translation>
    </message>
    <message>
        <source>some of its channels are stored at a lower resolution, which is not read; save all at the full one</source>
        <translation>einige seiner Kanäle sind in geringerer Auflösung gespeichert, was nicht gelesen wird; speichern Sie alle in der vollen</translation>
    </message>
    <message>
        <source>Some preferences in %1 are invalid and were reset to their defaults: %2. You can set them in Edit &gt; Preferences.</source>
        <translation>Einige Programmeinstellungen in %1 sind ungültig und wurden auf ihre Ausgangswerte zurückgesetzt: %2. Sie lassen sich unter Bearbeiten &gt; Einstellungen setzen.</translation>
    </message>
    <message>
        <source>Some were measured in the hall and some alone, so their times cannot be compared: their work is.</source>
        <translation>Einige wurden in der Halle gemessen und einige allein, daher lassen sich ihre Zeiten nicht vergleichen: Verglichen wird ihre Arbeit.</translation>
    </message>
    <message>
        <source>something else than a socket lies there; it was left alone, choose another path.</source>
        <translation>Dort liegt etwas anderes als ein Socket; es blieb unberührt, wählen Sie einen anderen Pfad.</translation>
    </message>
    <message>
        <source>something follows {1} that is no chunk</source>
        <translation>auf „{1}“ folgt etwas, das kein Block ist</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Source of the clouds' noise: evaluated at every step, or baked into a texture, which is quicker.</source>
        <extracomment>tables</extracomment>
        <translation>Quelle des Wolkenrauschens: bei jedem Schritt ausgewertet oder in eine Textur gebacken, was schneller ist.</translation>
    </message>
    <message>
        <source>Source of the noise for empty space and shadows: evaluated, or baked into a texture, which is quicker. The surface is always evaluated.</source>
        <extracomment>tables</extracomment>
        <translation>Quelle des Rauschens für leeren Raum und Schatten: ausgewertet oder in eine Textur gebacken, was schneller ist. Die Oberfläche wird immer ausgewertet.</translation>
    </message>
    <message>
        <source>Source of the sun's direction: angles of the work's own, or the hall's sun.</source>
        <extracomment>tables</extracomment>
        <translation>Quelle der Sonnenrichtung: eigene Winkel des Werks oder die Sonne der Halle.</translation>
    </message>
    <message>
        <source>Space opens a large preview.</source>
        <translation>Die Leertaste öffnet eine große Vorschau.</translation>
    </message>
    <message>
        <source>Spacing</source>
        <extracomment>tables</extracomment>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Span of a pitch chart, each way: 1 % is coarse, 0.1 % fine.</source>
        <translation>Spanne eines Pitch-Testcharts, nach beiden Seiten: 1 % ist grob, 0,1 % fein.</translation>
    </message>
    <message>
        <source>sparse indices must be unsigned integers</source>
        <translation>dünn besetzte Indizes müssen vorzeichenlose ganze Zahlen sein</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Specular</source>
        <extracomment>tables</extracomment>
        <translation>Spiegelnd</translation>
    </message>
    <message>
        <source>Speed</source>
        <extracomment>tables</extracomment>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed at which the bodies leave the ground when the button is pressed, in meters per second.</source>
        <extracomment>tables</extracomment>
        <translation>Geschwindigkeit, mit der die Körper beim Druck auf den Knopf abheben, in Metern pro Sekunde.</translation>
    </message>
    <message>
        <source>Speed at which the candy spins, relative to the slow and uneven rotation in the reference.</source>
        <extracomment>tables</extracomment>
        <translation>Tempo, mit dem sich das Bonbon dreht, gegenüber der langsamen, ungleichmäßigen Drehung in der Referenz.</translation>
    </message>
    <message>
        <source>Speed at which the draft carries the drifts of dust, in meters per second.</source>
        <extracomment>tables</extracomment>
        <translation>Geschwindigkeit, mit der der Luftzug die Staubschwaden trägt, in Metern pro Sekunde.</translation>
    </message>
    <message>
        <source>Speed at which the field moves towards the viewer, in meters per second.</source>
        <extracomment>tables</extracomment>
        <translation>Geschwindigkeit, mit der das Feld auf den Betrachter zukommt, in Metern pro Sekunde.</translation>
    </message>
    <message>
        <source>Speed at which the ice cream turns, in turns per second: negative turns the other way.</source>
        <extracomment>tables</extracomment>
        <translation>Tempo, mit dem sich das Eis dreht, in Umdrehungen pro Sekunde: Negative Werte drehen andersherum.</translation>
    </message>
    <message>
        <source>Speed at which the wind moves the lanterns, in meters per second.</source>
        <extracomment>tables</extracomment>
        <translation>Geschwindigkeit, mit der der Wind die Laternen bewegt, in Metern pro Sekunde.</translation>
    </message>
    <message>
        <source>Speed of looking</source>
        <translation>Tempo beim Umschauen</translation>
    </message>
    <message>
        <source>Speed of the animated mobile, in turns per second.</source>
        <extracomment>tables</extracomment>
        <translation>Tempo des bewegten Mobiles, in Umdrehungen pro Sekunde.</translation>
    </message>
    <message>
        <source>Speed of the camera around its target, per second: 0 stands still.</source>
        <extracomment>tables</extracomment>
        <translation>Geschwindigkeit der Kamera um ihr Ziel, pro Sekunde: 0 steht still.</translation>
    </message>
    <message>
        <source>Speed of the model's animation: 1 is as in its file, 0 stops it.</source>
        <extracomment>tables</extracomment>
        <translation>Tempo der Animation des Modells: 1 ist wie in der Datei, 0 hält sie an.</translation>
    </message>
    <message>
        <source>Speed of the waves: as in the reference, one rhythm for all; or by gravity, with long waves slow and short ones quick.</source>
        <extracomment>tables</extracomment>
        <translation>Tempo der Wellen: wie in der Referenz ein Takt für alle, oder durch Schwerkraft, mit langsamen langen und schnellen kurzen.</translation>
    </message>
    <message>
        <source>Speed of the wheel</source>
        <translation>Tempo des Mausrads</translation>
    </message>
    <message>
        <source>Spheres, cylinders, capsules</source>
        <translation>Kugeln, Zylinder, Kapseln</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>spin of 120 degrees</source>
        <translation>Drehung um 120 Grad</translation>
    </message>
    <message>
        <source>Split</source>
        <extracomment>tables</extracomment>
        <translation>Teilung</translation>
    </message>
    <message>
        <source>Split view</source>
        <extracomment>tables</extracomment>
        <translation>Geteilte Ansicht</translation>
    </message>
    <message>
        <source>Spread of a printed point (standard deviation), which counts as cross-talk; 10 to 40 µm are usual.</source>
        <translation>Ausbreitung eines gedruckten Punkts (Standardabweichung), die als Übersprechen zählt; üblich sind 10 bis 40 µm.</translation>
    </message>
    <message>
        <source>Spread what 8 bits cannot say over neighboring dots.</source>
        <translation>Verteilt, was 8 Bits nicht sagen können, auf benachbarte Punkte.</translation>
    </message>
    <message>
        <source>Spring model</source>
        <extracomment>tables</extracomment>
        <translation>Federmodell</translation>
    </message>
    <message>
        <source>Spring rate</source>
        <extracomment>tables</extracomment>
        <translation>Federrate</translation>
    </message>
    <message>
        <source>Sprinkle color</source>
        <extracomment>tables</extracomment>
        <translation>Streuselfarbe</translation>
    </message>
    <message>
        <source>Sprinkle colors</source>
        <extracomment>tables</extracomment>
        <translation>Streuselfarben</translation>
    </message>
    <message>
        <source>Sprinkle length</source>
        <extracomment>tables</extracomment>
        <translation>Streusellänge</translation>
    </message>
    <message>
        <source>Sprinkle seed</source>
        <extracomment>tables</extracomment>
        <translation>Streusel-Startwert</translation>
    </message>
    <message>
        <source>Sprinkle thickness</source>
        <extracomment>tables</extracomment>
        <translation>Streuseldicke</translation>
    </message>
    <message>
        <source>Sprinkles</source>
        <extracomment>tables</extracomment>
        <translation>Streusel</translation>
    </message>
    <message>
        <source>sprinkles</source>
        <extracomment>tables</extracomment>
        <translation>Streusel</translation>
    </message>
    <message>
        <source>Sprite sheet</source>
        <translation>Blatt mit Sprites</translation>
    </message>
    <message>
        <source>squeezed</source>
        <extracomment>tables</extracomment>
        <translation>gestaucht</translation>
    </message>
    <message>
        <source>Stacked panels</source>
        <translation>Gestapelte Bedienfelder</translation>
    </message>
    <message>
        <source>Stage</source>
        <extracomment>tables</extracomment>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Stage of the build-up, after the slides of its author; each stage includes all before it.</source>
        <extracomment>tables</extracomment>
        <translation>Stufe des Aufbaus, nach den Folien seines Autors; jede Stufe enthält alle davor.</translation>
    </message>
    <message>
        <source>Stage time</source>
        <extracomment>tables</extracomment>
        <translation>Zeit je Stufe</translation>
    </message>
    <message>
        <source>standard</source>
        <extracomment>tables</extracomment>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Standard deviation of the ink's blur: high mixes neighboring views (crosstalk).</source>
        <extracomment>tables</extracomment>
        <translation>Standardabweichung der Unschärfe der Tinte: Hohe Werte vermischen benachbarte Ansichten (Übersprechen).</translation>
    </message>
    <message>
        <source>Stars</source>
        <extracomment>tables</extracomment>
        <translation>Sterne</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>start and end are the same point; move one of them</source>
        <translation>Anfang und Ende sind derselbe Punkt; verschieben Sie einen davon</translation>
    </message>
    <message>
        <source>Start of the segment.</source>
        <translation>Anfang der Strecke.</translation>
    </message>
    <message>
        <source>Start radius</source>
        <translation>Radius am Anfang</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>starting the encoder</source>
        <translation>das Starten des Encoders</translation>
    </message>
    <message>
        <source>starting the file</source>
        <translation>das Beginnen der Datei</translation>
    </message>
    <message>
        <source>starting the filters</source>
        <translation>das Starten der Filter</translation>
    </message>
    <message>
        <source>Starts the step-by-step lesson about the visited exhibit.</source>
        <translation>Startet die Lektion, die Schritt für Schritt durch das besuchte Exponat führt.</translation>
    </message>
    <message>
        <source>Stay open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>Step lengths of the rays: as in the reference (half the field's value, the height above the water, equal steps through clouds), or as far as bounds of the slope allow.</source>
        <extracomment>tables</extracomment>
        <translation>Schrittlängen der Strahlen: wie in der Referenz (halber Wert des Felds, Höhe über dem Wasser, gleiche Schritte durch Wolken) oder so weit, wie Schranken der Steigung erlauben.</translation>
    </message>
    <message>
        <source>Step limit</source>
        <extracomment>tables</extracomment>
        <translation>Schrittgrenze</translation>
    </message>
    <message>
        <source>Step limit of the right half.</source>
        <extracomment>tables</extracomment>
        <translation>Schrittgrenze der rechten Hälfte.</translation>
    </message>
    <message>
        <source>Step of the finite differences for normals near the eye: too small suffers from rounding, too large rounds creases.</source>
        <extracomment>tables</extracomment>
        <translation>Schritt der finiten Differenzen für Normalen nahe dem Auge: Zu kleine leiden unter Rundung, zu große runden Falten.</translation>
    </message>
    <message>
        <source>Step of the finite differences for normals: too small suffers from rounding, too large rounds creases.</source>
        <extracomment>tables</extracomment>
        <translation>Schritt der finiten Differenzen für Normalen: Zu kleine leiden unter Rundung, zu große runden Falten.</translation>
    </message>
    <message>
        <source>steps</source>
        <extracomment>tables</extracomment>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Steps of half and of double that length give the same normals.</source>
        <translation>Schritte von halber und doppelter Länge ergeben dieselben Normalen.</translation>
    </message>
    <message>
        <source>Stereo in red and cyan</source>
        <translation>Stereo in Rot und Cyan</translation>
    </message>
    <message>
        <source>stiff fur in long steps</source>
        <translation>steifes Fell in langen Schritten</translation>
    </message>
    <message>
        <source>Stiffness of the fur as the frequency at which it swings: low sways, high snaps back.</source>
        <extracomment>tables</extracomment>
        <translation>Steifheit des Fells als Frequenz, mit der es schwingt: Niedrige Werte schwanken, hohe schnellen zurück.</translation>
    </message>
    <message>
        <source>Still being written: %1.</source>
        <translation>Wird noch geschrieben: %1.</translation>
    </message>
    <message>
        <source>Still life</source>
        <translation>Stillleben</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>%1 beenden</translation>
    </message>
    <message>
        <source>Stop and start the exhibits' clock</source>
        <translation>Die Uhr der Exponate anhalten und starten</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Hier beenden</translation>
    </message>
    <message>
        <source>Stop or start the clock</source>
        <translation>Uhr anhalten oder starten</translation>
    </message>
    <message>
        <source>Stop writing and close</source>
        <translation>Schreiben abbrechen und schließen</translation>
    </message>
    <message>
        <source>stopped early</source>
        <translation>vorzeitig angehalten</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Stopped; the frames so far are whole, and the same command goes on with the next one.</source>
        <translation>Abgebrochen; die bisherigen Frames sind vollständig, und derselbe Befehl fährt mit dem nächsten fort.</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Hält an</translation>
    </message>
    <message>
        <source>Stops and starts the exhibits' clock.</source>
        <translation>Hält die Uhr der Exponate an und lässt sie weiterlaufen.</translation>
    </message>
    <message>
        <source>Storm</source>
        <translation>Sturm</translation>
    </message>
    <message>
        <source>Strand roundness</source>
        <extracomment>tables</extracomment>
        <translation>Haarrundung</translation>
    </message>
    <message>
        <source>Strands</source>
        <extracomment>tables</extracomment>
        <translation>Haare</translation>
    </message>
    <message>
        <source>Strawberry</source>
        <translation>Erdbeere</translation>
    </message>
    <message>
        <source>Streak</source>
        <extracomment>tables</extracomment>
        <translation>Strahlenlänge</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Strength of an octave relative to the one before: low is smooth, high is rough.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke einer Oktave gegenüber der vorigen: Niedrige Werte sind glatt, hohe rau.</translation>
    </message>
    <message>
        <source>Strength of domain warping, in cells: 0 is off, high folds and swirls.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Domain Warping, in Zellen: 0 ist aus, hohe Werte falten und wirbeln.</translation>
    </message>
    <message>
        <source>Strength of forward scattering in the clouds: high gives silver edges in front of the sun.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Vorwärtsstreuung in den Wolken: Hohe Werte geben silberne Ränder vor der Sonne.</translation>
    </message>
    <message>
        <source>Strength of random swirls in the coat: 0 is even, high is tousled.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke zufälliger Wirbel im Fell: 0 ist gleichmäßig, hohe Werte sind zerzaust.</translation>
    </message>
    <message>
        <source>Strength of the ambient occlusion: 0 is off.</source>
        <translation>Stärke der Umgebungsverdeckung: 0 ist aus.</translation>
    </message>
    <message>
        <source>Strength of the combing to one side: 0 leaves strands upright, high lays them flat.</source>
        <extracomment>tables</extracomment>
        <translation>Wie stark das Fell zu einer Seite gekämmt ist: 0 lässt die Haare aufrecht, hohe Werte legen sie flach.</translation>
    </message>
    <message>
        <source>Strength of the dark lines on the borders of near objects: 0 draws none.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der dunklen Linien an den Rändern naher Objekte: 0 zeichnet keine.</translation>
    </message>
    <message>
        <source>Strength of the daylight left in the sky: 0 is deep night.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Tageslichts, das noch am Himmel ist: 0 ist tiefe Nacht.</translation>
    </message>
    <message>
        <source>Strength of the dithering: at 1 average colors are kept, less leaves calm areas.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Ditherings: Bei 1 bleiben mittlere Farben erhalten, weniger lässt ruhige Flächen.</translation>
    </message>
    <message>
        <source>Strength of the draft over the pit: 0 is still air, above 0 the fur keeps moving.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Luftzugs über der Grube: 0 ist ruhige Luft, darüber bleibt das Fell in Bewegung.</translation>
    </message>
    <message>
        <source>Strength of the flames' light: 0 gives none.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Lichts der Flammen: 0 gibt keines.</translation>
    </message>
    <message>
        <source>Strength of the flickering: 0 burns evenly.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Flackerns: 0 brennt gleichmäßig.</translation>
    </message>
    <message>
        <source>Strength of the hall's ambient light that the dust scatters: 1 is physical, at 0 the dust only darkens.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Umgebungslichts der Halle, das der Staub streut: 1 ist physikalisch, bei 0 verdunkelt der Staub nur.</translation>
    </message>
    <message>
        <source>Strength of the lamp in front of the niche: 0 switches it off.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Lampe vor der Nische: 0 schaltet sie aus.</translation>
    </message>
    <message>
        <source>Strength of the lamp in the vault above the pit: 0 switches it off.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Lampe im Gewölbe über der Grube: 0 schaltet sie aus.</translation>
    </message>
    <message>
        <source>Strength of the lamp in the vault that is aimed at the card: 0 leaves it to the hall's light.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Lampe im Gewölbe, die auf die Karte gerichtet ist: 0 überlässt sie dem Licht der Halle.</translation>
    </message>
    <message>
        <source>Strength of the lamps in the vault: 0 is a dark night, 1 is enough to read by.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Lampen im Gewölbe: 0 ist eine dunkle Nacht, 1 genügt zum Lesen.</translation>
    </message>
    <message>
        <source>Strength of the lanterns' light on the wall and floor beside the frame: 0 gives none.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Laternenlichts auf Wand und Boden neben dem Rahmen: 0 gibt keines.</translation>
    </message>
    <message>
        <source>Strength of the light lines on edges that face the camera: 0 draws none.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der hellen Linien auf Kanten, die zur Kamera zeigen: 0 zeichnet keine.</translation>
    </message>
    <message>
        <source>Strength of the moonlight: 0 is a night without a moon.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Mondlichts: 0 ist eine Nacht ohne Mond.</translation>
    </message>
    <message>
        <source>Strength of the reference's sun: 0 switches it off.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Sonne der Referenz: 0 schaltet sie aus.</translation>
    </message>
    <message>
        <source>Strength of the screen-space rays: 0 makes none. In the plain sum, the strength of each sample.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke der Strahlen im Bildraum: 0 erzeugt keine. In der einfachen Summe die Stärke jedes Samples.</translation>
    </message>
    <message>
        <source>Strength of the sky's light through window and oculus: 0 is a black sky.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Himmelslichts durch Fenster und Oculus: 0 ist ein schwarzer Himmel.</translation>
    </message>
    <message>
        <source>Strength of the sunlight relative to the sky: 0 is an overcast day.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Sonnenlichts gegenüber dem Himmel: 0 ist ein bedeckter Tag.</translation>
    </message>
    <message>
        <source>Strength of the sunlight that the dust scatters: 1 is physical for the air density, 0 shows no beams.</source>
        <extracomment>tables</extracomment>
        <translation>Stärke des Sonnenlichts, das der Staub streut: 1 ist physikalisch für die Luftdichte, 0 zeigt keine Strahlen.</translation>
    </message>
    <message>
        <source>Strength of the white highlight.</source>
        <translation>Stärke des weißen Glanzlichts.</translation>
    </message>
    <message>
        <source>Strength with which the ribs (noise stretched along the lenses) bend the highlight: 0 leaves it smooth.</source>
        <extracomment>tables</extracomment>
        <translation>Wie stark die Rippen (entlang der Linsen gestrecktes Rauschen) das Glanzlicht verbiegen: 0 lässt es glatt.</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>strecken</translation>
    </message>
    <message>
        <source>Strips</source>
        <extracomment>tables</extracomment>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Studied with {1} at {2} instead of {3}, so that {4} acts.</source>
        <translation>Untersucht mit {1} auf {2} statt {3}, damit {4} wirkt.</translation>
    </message>
    <message>
        <source>Studied with {1} at {2} instead of {3}, so that {4} shows.</source>
        <translation>Untersucht mit {1} auf {2} statt {3}, damit sich {4} zeigt.</translation>
    </message>
    <message>
        <source>Studied with {1} at {2} instead of {3}, which would limit {4}.</source>
        <translation>Untersucht mit {1} auf {2} statt {3}, das {4} begrenzen würde.</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>Studies compared</source>
        <translation>Verglichene Studien</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>study {1}: a parameter is the exhibit's own or the hall's, as in hall.supersamples.</source>
        <translation>study {=1}: Ein Parameter ist der des Exponats oder der Halle, wie in hall.supersamples.</translation>
    </message>
    <message>
        <source>study {1}: named twice; name each parameter once.</source>
        <translation>study {=1}: zweimal genannt; nennen Sie jeden Parameter einmal.</translation>
    </message>
    <message>
        <source>study {1}: {2} has it, but no value of it is more exact than another; give one of {3}</source>
        <translation>study {=1}: {=2} hat ihn, aber kein Wert davon ist genauer als ein anderer; geben Sie einen von {=3} an</translation>
    </message>
    <message>
        <source>study {1}: {2} has no such parameter; give one of {3}</source>
        <translation>study {=1}: {=2} hat keinen solchen Parameter; geben Sie einen an von {=3}</translation>
    </message>
    <message>
        <source>Subtractions</source>
        <translation>Differenzen</translation>
    </message>
    <message>
        <source>Sum</source>
        <extracomment>tables</extracomment>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Summation along the ray: the mean, whose brightness does not depend on the number of samples, or the plain sum of the reference, which grows with it.</source>
        <extracomment>tables</extracomment>
        <translation>Summierung entlang des Strahls: das Mittel, dessen Helligkeit nicht von der Zahl der Samples abhängt, oder die einfache Summe der Referenz, die mit ihr wächst.</translation>
    </message>
    <message>
        <source>Sun</source>
        <extracomment>tables</extracomment>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>Sun azimuth</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenazimut</translation>
    </message>
    <message>
        <source>sun beyond the edge</source>
        <translation>Sonne jenseits des Randes</translation>
    </message>
    <message>
        <source>Sun by</source>
        <extracomment>tables</extracomment>
        <translation>Sonne nach</translation>
    </message>
    <message>
        <source>Sun disk</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenscheibe</translation>
    </message>
    <message>
        <source>Sun elevation</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenhöhe</translation>
    </message>
    <message>
        <source>Sun light</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenlicht</translation>
    </message>
    <message>
        <source>Sun shadows</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenschatten</translation>
    </message>
    <message>
        <source>sun shadows are switched off</source>
        <translation>Sonnenschatten sind ausgeschaltet</translation>
    </message>
    <message>
        <source>Sun strength</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenstärke</translation>
    </message>
    <message>
        <source>Sun temperature</source>
        <extracomment>tables</extracomment>
        <translation>Sonnentemperatur</translation>
    </message>
    <message>
        <source>Sun width</source>
        <extracomment>tables</extracomment>
        <translation>Sonnendurchmesser</translation>
    </message>
    <message>
        <source>sun's disk</source>
        <extracomment>tables</extracomment>
        <translation>Sonnenscheibe</translation>
    </message>
    <message>
        <source>sun, sky or lamps have changed</source>
        <translation>Sonne, Himmel oder Lampen haben sich geändert</translation>
    </message>
    <message>
        <source>Sunbeams: smeared across the picture, or marched through the dust.</source>
        <translation>Sonnenstrahlen: über das Bild verwischt oder durch den Staub abgeschritten.</translation>
    </message>
    <message>
        <source>Sundae</source>
        <translation>Eisbecher</translation>
    </message>
    <message>
        <source>Supersamples</source>
        <extracomment>tables</extracomment>
        <translation>Supersamples</translation>
    </message>
    <message>
        <source>Supplied with the exhibit: it can be duplicated, but not changed.</source>
        <translation>Gehört zum Exponat: lässt sich duplizieren, aber nicht ändern.</translation>
    </message>
    <message>
        <source>Sw&amp;ap A and B</source>
        <translation>A &amp;und B vertauschen</translation>
    </message>
    <message>
        <source>Swap A and B</source>
        <translation>A und B vertauschen</translation>
    </message>
    <message>
        <source>Table saved to %1.</source>
        <translation>Tabelle in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Tables and charts (*.csv *.json *.png *.svg)</source>
        <translation>Tabellen und Diagramme (*.csv *.json *.png *.svg)</translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation>Tag %1</translation>
    </message>
    <message>
        <source>Tag a preset</source>
        <translation>Preset mit Tags versehen</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Tags</translation>
    </message>
    <message>
        <source>Tags of %1</source>
        <translation>Tags von %1</translation>
    </message>
    <message>
        <source>Tags, separated by commas</source>
        <translation>Tags, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>Tags: %1</source>
        <translation>Tags: %1</translation>
    </message>
    <message>
        <source>Take %1</source>
        <translation>%1 übernehmen</translation>
    </message>
    <message>
        <source>Take it</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Take the file's</source>
        <translation>Die der Datei nehmen</translation>
    </message>
    <message>
        <source>Take variation %1 of nine %2</source>
        <translation>Variation %1 von neun übernehmen %2</translation>
    </message>
    <message>
        <source>Tall</source>
        <extracomment>tables</extracomment>
        <translation>Bildausschnitt</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Technique</source>
        <extracomment>tables</extracomment>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Technique that makes the beams: blurring the bright sky across the picture (screen space), or ray marching the sun's shadows through dusty air (volume).</source>
        <extracomment>tables</extracomment>
        <translation>Technik, die die Strahlen erzeugt: Verwischen des hellen Himmels über das Bild (Bildraum) oder Raymarching durch die Schatten der Sonne in staubiger Luft (Volumen).</translation>
    </message>
    <message>
        <source>Teddy</source>
        <translation>Teddy</translation>
    </message>
    <message>
        <source>Temperature</source>
        <extracomment>tables</extracomment>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Temporal antialiasing</source>
        <extracomment>tables</extracomment>
        <translation>Zeitliche Kantenglättung</translation>
    </message>
    <message>
        <source>tent 3x3</source>
        <extracomment>tables</extracomment>
        <translation>Zelt 3x3</translation>
    </message>
    <message>
        <source>tent 5x5</source>
        <extracomment>tables</extracomment>
        <translation>Zelt 5x5</translation>
    </message>
    <message>
        <source>Tessellation</source>
        <extracomment>tables</extracomment>
        <translation>Tessellierung</translation>
    </message>
    <message>
        <source>test scene</source>
        <extracomment>tables</extracomment>
        <translation>Testszene</translation>
    </message>
    <message>
        <source>tetrahedron</source>
        <extracomment>tables</extracomment>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Text size of the window, relative to the desktop's.</source>
        <translation>Textgröße des Fensters, gegenüber der des Desktops.</translation>
    </message>
    <message>
        <source>texture fetches</source>
        <translation>Texturzugriffe</translation>
    </message>
    <message>
        <source>the air is clear</source>
        <translation>die Luft ist klar</translation>
    </message>
    <message>
        <source>the air is out of view</source>
        <translation>die Luft ist außer Sicht</translation>
    </message>
    <message>
        <source>the ambient light is black</source>
        <translation>das Umgebungslicht ist schwarz</translation>
    </message>
    <message>
        <source>the axis is 0, 0, 0; give a direction</source>
        <translation>die Achse ist 0, 0, 0; geben Sie eine Richtung an</translation>
    </message>
    <message>
        <source>the back, from above</source>
        <translation>die Rückseite, von oben</translation>
    </message>
    <message>
        <source>the ball grows and shrinks</source>
        <translation>der Ball wächst und schrumpft</translation>
    </message>
    <message>
        <source>The baseline's scale is {1}; give 0 or more, 1 for depth in its true measure.</source>
        <translation>Der Maßstab der Basis ist {1}; geben Sie 0 oder mehr an, 1 für Tiefe in ihrem wahren Maß.</translation>
    </message>
    <message>
        <source>the beams are added to the picture</source>
        <translation>die Strahlen werden zum Bild addiert</translation>
    </message>
    <message>
        <source>the beams are out of view</source>
        <translation>die Strahlen sind außer Sicht</translation>
    </message>
    <message>
        <source>the bleed is {1}; give 0 or more</source>
        <translation>der Anschnitt ist {1}; geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>the block that says whose lesson this is is missing; write ```json, {&quot;format&quot;: &quot;vitrine-lesson&quot;, &quot;version&quot;: 1, &quot;exhibit&quot;: ...} and ``` below the title.</source>
        <translation>der Block, der sagt, wessen Lektion das ist, fehlt; schreiben Sie ```json, {&quot;format&quot;: &quot;vitrine-lesson&quot;, &quot;version&quot;: 1, &quot;exhibit&quot;: ...} und ``` unter den Titel.</translation>
    </message>
    <message>
        <source>the bodies keep light off the floor</source>
        <translation>die Körper halten Licht vom Boden ab</translation>
    </message>
    <message>
        <source>The bookmark &quot;{1}&quot; is inside of a wall or of what stands in the hall; move it.</source>
        <translation>Das Lesezeichen „{=1}“ liegt in einer Wand oder in etwas, das in der Halle steht; versetzen Sie es.</translation>
    </message>
    <message>
        <source>the border is {1}; give 0 or more</source>
        <translation>der Rand ist {1}; geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>the brightness of the stars is 0</source>
        <translation>die Helligkeit der Sterne ist 0</translation>
    </message>
    <message>
        <source>the buffer has {1} bytes, fewer than its byteLength of {2}; export the file again.</source>
        <translation>der Puffer hat {1} Bytes, weniger als seine byteLength von {2}; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the buffers together are larger than {1} bytes; simplify the model.</source>
        <translation>die Puffer sind zusammen größer als {1} Bytes; vereinfachen Sie das Modell.</translation>
    </message>
    <message>
        <source>the buffers without data are larger than {1} bytes; give them a uri.</source>
        <translation>die Puffer ohne Daten sind größer als {1} Bytes; geben Sie ihnen ein uri.</translation>
    </message>
    <message>
        <source>the build-up has not come so far</source>
        <translation>der Aufbau ist noch nicht so weit</translation>
    </message>
    <message>
        <source>the camera jumped</source>
        <translation>die Kamera ist gesprungen</translation>
    </message>
    <message>
        <source>the camera turned too far</source>
        <translation>die Kamera hat sich zu weit gedreht</translation>
    </message>
    <message>
        <source>the camera, time or world has changed</source>
        <translation>Kamera, Zeit oder Welt haben sich geändert</translation>
    </message>
    <message>
        <source>the candles do not burn</source>
        <translation>die Kerzen brennen nicht</translation>
    </message>
    <message>
        <source>The card as both eyes see it</source>
        <translation>Die Karte, wie beide Augen sie sehen</translation>
    </message>
    <message>
        <source>The card cannot show {1}: {2}</source>
        <translation>Die Karte kann {=1} nicht zeigen: {2}</translation>
    </message>
    <message>
        <source>The card is left out until it can be read.</source>
        <translation>Die Karte wird weggelassen, bis sie gelesen werden kann.</translation>
    </message>
    <message>
        <source>the channels of the picture have no names</source>
        <translation>die Kanäle des Bildes haben keine Namen</translation>
    </message>
    <message>
        <source>The check mark shows or hides it. Drag it, or press Ctrl and the arrows, to reorder; F2 renames.</source>
        <translation>Das Häkchen blendet ein oder aus. Ziehen, oder Strg mit den Pfeiltasten, ordnet um; F2 benennt um.</translation>
    </message>
    <message>
        <source>The child bent about the z axis, along x.</source>
        <translation>Das Kind, um die z-Achse gebogen, entlang x.</translation>
    </message>
    <message>
        <source>The child cut at the origin and pulled apart along the axes.</source>
        <translation>Das Kind, am Ursprung geschnitten und entlang der Achsen auseinandergezogen.</translation>
    </message>
    <message>
        <source>The child grown by a radius, with round edges.</source>
        <translation>Das Kind, um einen Radius vergrößert, mit runden Kanten.</translation>
    </message>
    <message>
        <source>the child is so wide that {1} copies would be asked at every point; make it smaller or its copies fewer or farther apart</source>
        <translation>das Kind ist so breit, dass an jedem Punkt {1} Kopien gefragt würden; machen Sie es kleiner, oder seine Kopien weniger oder weiter auseinander</translation>
    </message>
    <message>
        <source>The child twisted about the y axis.</source>
        <translation>Das Kind, um die y-Achse verdrillt.</translation>
    </message>
    <message>
        <source>The child with its surface displaced by smooth noise.</source>
        <translation>Das Kind, dessen Oberfläche durch glattes Rauschen verschoben ist.</translation>
    </message>
    <message>
        <source>The child's cross-section at z = 0, extruded along z.</source>
        <translation>Der Querschnitt des Kindes bei z = 0, entlang z gestreckt.</translation>
    </message>
    <message>
        <source>The child's cross-section at z = 0, revolved around the y axis.</source>
        <translation>Der Querschnitt des Kindes bei z = 0, um die y-Achse gedreht.</translation>
    </message>
    <message>
        <source>the clock jumped</source>
        <translation>die Uhr ist gesprungen</translation>
    </message>
    <message>
        <source>The clock waits because nothing shown is moving; it continues when something moves.</source>
        <translation>Die Uhr wartet, weil sich nichts Gezeigtes bewegt; sie läuft weiter, sobald sich etwas bewegt.</translation>
    </message>
    <message>
        <source>the clouds use baked noise</source>
        <translation>die Wolken verwenden gebackenes Rauschen</translation>
    </message>
    <message>
        <source>the cone pre-pass is switched off</source>
        <translation>der Kegel-Vorlauf ist ausgeschaltet</translation>
    </message>
    <message>
        <source>the conic constant is not a number</source>
        <translation>die konische Konstante ist keine Zahl</translation>
    </message>
    <message>
        <source>The convergence plane is at {1} m; it must lie in front of the camera, farther than {2} m.</source>
        <translation>Die Konvergenzebene liegt bei {1} m; sie muss vor der Kamera liegen, weiter als {2} m.</translation>
    </message>
    <message>
        <source>The convex hull of two spheres on the y axis, the lower one at the origin.</source>
        <translation>Die konvexe Hülle zweier Kugeln auf der y-Achse, die untere im Ursprung.</translation>
    </message>
    <message>
        <source>The convex hull of two spheres, at start and end.</source>
        <translation>Die konvexe Hülle zweier Kugeln, an Anfang und Ende.</translation>
    </message>
    <message>
        <source>the copies are nearer than 0.1 mm; give a larger spacing, or 0</source>
        <translation>die Kopien liegen näher als 0.1 mm; geben Sie einen größeren Abstand an, oder 0</translation>
    </message>
    <message>
        <source>the corners lie on one line, so it has no area; move one of them aside</source>
        <translation>die Ecken liegen auf einer Geraden, daher hat es keine Fläche; rücken Sie eine davon zur Seite</translation>
    </message>
    <message>
        <source>The cross moves, A presses, B closes</source>
        <translation>Das Kreuz bewegt, A drückt, B schließt</translation>
    </message>
    <message>
        <source>The curve</source>
        <translation>Die Kurve</translation>
    </message>
    <message>
        <source>the cut leaves nothing; raise it above -radius</source>
        <translation>der Schnitt lässt nichts übrig; heben Sie ihn über -radius</translation>
    </message>
    <message>
        <source>the density of the rays is 0</source>
        <translation>die Dichte der Strahlen ist 0</translation>
    </message>
    <message>
        <source>the depth is stored when it is drawn</source>
        <translation>die Tiefe wird beim Zeichnen gespeichert</translation>
    </message>
    <message>
        <source>the description</source>
        <translation>die Beschreibung</translation>
    </message>
    <message>
        <source>the direction is {1} degrees; give -90 to 90</source>
        <translation>die Richtung ist {1} Grad; geben Sie -90 bis 90 an</translation>
    </message>
    <message>
        <source>The dots as they will be printed; lines are the edges between lenses.
The wheel, + and - zoom; dragging and the arrows move; Home goes to the middle.</source>
        <translation>Die Punkte, wie sie gedruckt werden; Linien sind die Grenzen zwischen Linsen.
Mausrad, + und - zoomen; Ziehen und Pfeiltasten verschieben; Pos1 geht zur Mitte.</translation>
    </message>
    <message>
        <source>the dust swallows all light</source>
        <translation>der Staub verschluckt alles Licht</translation>
    </message>
    <message>
        <source>the dust swallows the light of the sun</source>
        <translation>der Staub verschluckt das Licht der Sonne</translation>
    </message>
    <message>
        <source>The edited scene (JSON) with all changes that are not in its file yet. Resetting it discards them.</source>
        <extracomment>tables</extracomment>
        <translation>Die bearbeitete Szene (JSON) mit allen Änderungen, die noch nicht in ihrer Datei stehen. Zurücksetzen verwirft sie.</translation>
    </message>
    <message>
        <source>the environment is behind the exhibit</source>
        <translation>die Umgebung liegt hinter dem Exponat</translation>
    </message>
    <message>
        <source>the evaluations channel is requested</source>
        <translation>der Kanal der Auswertungen ist verlangt</translation>
    </message>
    <message>
        <source>The exhibit alone, in the hall's light; around it the picture is transparent.</source>
        <translation>Das Exponat allein, im Licht der Halle; um es herum ist das Bild transparent.</translation>
    </message>
    <message>
        <source>the exhibit is shown alone</source>
        <translation>das Exponat wird allein gezeigt</translation>
    </message>
    <message>
        <source>the exhibit is shown alone, without walls to bound the air</source>
        <translation>das Exponat wird allein gezeigt, ohne Wände, an denen die Luft endet</translation>
    </message>
    <message>
        <source>The extension {1} is not supported and was ignored.</source>
        <translation>Die Erweiterung {=1} wird nicht unterstützt und wurde übergangen.</translation>
    </message>
    <message>
        <source>The eye must be farther away than the sheet is thick.</source>
        <translation>Das Auge muss weiter weg sein, als die Folie dick ist.</translation>
    </message>
    <message>
        <source>The eye's angle must lie between -85 and 85 degrees.</source>
        <translation>Der Winkel des Auges muss zwischen -85 und 85 Grad liegen.</translation>
    </message>
    <message>
        <source>the field is shown</source>
        <translation>das Feld wird gezeigt</translation>
    </message>
    <message>
        <source>the field of view changed</source>
        <translation>der Sichtwinkel hat sich geändert</translation>
    </message>
    <message>
        <source>the file cannot be shown without {1}, which is not supported; export it without that.</source>
        <translation>die Datei kann ohne {=1} nicht gezeigt werden, was nicht unterstützt wird; exportieren Sie sie ohne das.</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>the file has {1} bytes, more than the {2} allowed for JSON</source>
        <translation>die Datei hat {1} Bytes, mehr als die für JSON erlaubten {2}</translation>
    </message>
    <message>
        <source>the file holds more than {1} values</source>
        <translation>die Datei enthält mehr als {1} Werte</translation>
    </message>
    <message>
        <source>the file is empty; it should hold JSON</source>
        <translation>die Datei ist leer; sie sollte JSON enthalten</translation>
    </message>
    <message>
        <source>the file is read-only; choose another name.</source>
        <translation>die Datei ist schreibgeschützt; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>the file is UTF-16; save it as UTF-8</source>
        <translation>die Datei ist UTF-16; speichern Sie sie als UTF-8</translation>
    </message>
    <message>
        <source>the file lost a channel</source>
        <translation>die Datei hat einen Kanal verloren</translation>
    </message>
    <message>
        <source>the file starts with two byte order marks; delete one</source>
        <translation>die Datei beginnt mit zwei Byte-Reihenfolge-Markierungen; löschen Sie eine</translation>
    </message>
    <message>
        <source>The film: .mp4, .webm, .gif, .webp or .apng, or frames as in frames/%04d.png.</source>
        <translation>Der Film: .mp4, .webm, .gif, .webp oder .apng, oder Frames wie in frames/%04d.png.</translation>
    </message>
    <message>
        <source>the floor is in view</source>
        <translation>der Boden ist im Blick</translation>
    </message>
    <message>
        <source>the floor is out of view</source>
        <translation>der Boden ist außer Sicht</translation>
    </message>
    <message>
        <source>the fog is too thin to show the light of the lanterns</source>
        <translation>der Nebel ist zu dünn, um das Licht der Laternen zu zeigen</translation>
    </message>
    <message>
        <source>The former A</source>
        <translation>Das frühere A</translation>
    </message>
    <message>
        <source>the free plinth is empty</source>
        <translation>der freie Sockel ist leer</translation>
    </message>
    <message>
        <source>The generated shader {1}, line {2}: {3}</source>
        <translation>Der erzeugte Shader {=1}, Zeile {2}: {=3}</translation>
    </message>
    <message>
        <source>The graphics driver cannot store the buffer &quot;{1}&quot; of {2} bytes; choose fewer or smaller things.</source>
        <translation>Der Grafiktreiber kann den Puffer „{=1}“ von {2} Bytes nicht speichern; wählen Sie weniger oder Kleineres.</translation>
    </message>
    <message>
        <source>The graphics driver cannot store the image &quot;{1}&quot; of {2} × {3} pixels; choose a smaller size.</source>
        <translation>Der Grafiktreiber kann das Bild „{=1}“ von {2} × {3} Pixeln nicht speichern; wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>The graphics driver makes no second context that shares with the first.</source>
        <translation>Der Grafiktreiber legt keinen zweiten Kontext an, der mit dem ersten teilt.</translation>
    </message>
    <message>
        <source>the ground is switched off</source>
        <translation>der Boden ist ausgeschaltet</translation>
    </message>
    <message>
        <source>the guard is {1}; give a part of a strip, 0 to 1</source>
        <translation>der Übergang ist {1}; geben Sie einen Teil eines Streifens an, 0 bis 1</translation>
    </message>
    <message>
        <source>The half of the child at positive coordinates, and its mirror image.</source>
        <translation>Die Hälfte des Kindes mit positiven Koordinaten und ihr Spiegelbild.</translation>
    </message>
    <message>
        <source>The hall</source>
        <translation>Die Halle</translation>
    </message>
    <message>
        <source>the hall as a whole</source>
        <translation>der Halle als Ganzes</translation>
    </message>
    <message>
        <source>The hall cannot be turned; name an exhibit.</source>
        <translation>Die Halle lässt sich nicht drehen; nennen Sie ein Exponat.</translation>
    </message>
    <message>
        <source>The hall in clear air: all else is what beams and dust make of it.</source>
        <translation>Die Halle in klarer Luft: Alles andere ist, was Strahlen und Staub aus ihr machen.</translation>
    </message>
    <message>
        <source>the hall is around the visitor</source>
        <translation>die Halle umgibt den Besucher</translation>
    </message>
    <message>
        <source>the hall's</source>
        <extracomment>tables</extracomment>
        <translation>die der Halle</translation>
    </message>
    <message>
        <source>the handle, from near</source>
        <translation>der Henkel, aus der Nähe</translation>
    </message>
    <message>
        <source>The heat map ranges from 0 to %1 (%2).</source>
        <translation>Die Heatmap reicht von 0 bis %1 (%2).</translation>
    </message>
    <message>
        <source>the height</source>
        <translation>die Höhe</translation>
    </message>
    <message>
        <source>the hole takes all of it; make it smaller</source>
        <translation>das Loch nimmt alles weg; machen Sie es kleiner</translation>
    </message>
    <message>
        <source>the horizon</source>
        <translation>zum Horizont</translation>
    </message>
    <message>
        <source>the image has another form</source>
        <translation>das Bild hat eine andere Form</translation>
    </message>
    <message>
        <source>the ink's spread is {1}; give 0 or more</source>
        <translation>der Tintenverlauf ist {1}; geben Sie 0 oder mehr an</translation>
    </message>
    <message>
        <source>The job was stopped.</source>
        <translation>Der Auftrag wurde angehalten.</translation>
    </message>
    <message>
        <source>the key &quot;kind&quot; is missing; add it.</source>
        <translation>der Schlüssel &quot;kind&quot; fehlt; ergänzen Sie ihn.</translation>
    </message>
    <message>
        <source>the key &quot;{1}&quot; is missing; add it.</source>
        <translation>der Schlüssel „{=1}“ fehlt; fügen Sie ihn hinzu.</translation>
    </message>
    <message>
        <source>the key &quot;{1}&quot; is missing; it is no study that Vitrine wrote.</source>
        <translation>der Schlüssel „{=1}“ fehlt; das ist keine Studie, die Vitrine geschrieben hat.</translation>
    </message>
    <message>
        <source>The knee: %1, error %2, cost %3.</source>
        <translation>Das Knie: %1, Fehler %2, Kosten %3.</translation>
    </message>
    <message>
        <source>the lamps are switched off</source>
        <translation>die Lampen sind ausgeschaltet</translation>
    </message>
    <message>
        <source>The language of the window will be %1 after the next start.</source>
        <translation>Die Sprache des Fensters ist ab dem nächsten Start %1.</translation>
    </message>
    <message>
        <source>the largest radius is more than 1000 times the smallest; bring them nearer</source>
        <translation>der größte Radius ist mehr als das 1000-fache des kleinsten; bringen Sie sie näher zusammen</translation>
    </message>
    <message>
        <source>the layer &quot;{1}&quot;</source>
        <translation>die Ebene „{1}“</translation>
    </message>
    <message>
        <source>the light in the air does not fit its points</source>
        <translation>das Licht in der Luft passt nicht zu seinen Punkten</translation>
    </message>
    <message>
        <source>the light of its sources does not fit its directions</source>
        <translation>das Licht ihrer Quellen passt nicht zu seinen Richtungen</translation>
    </message>
    <message>
        <source>the light of the sun is black</source>
        <translation>das Licht der Sonne ist schwarz</translation>
    </message>
    <message>
        <source>the lighting of the reference has none</source>
        <translation>die Beleuchtung der Referenz hat keine</translation>
    </message>
    <message>
        <source>the main layer</source>
        <translation>die Hauptebene</translation>
    </message>
    <message>
        <source>The marched field</source>
        <translation>Das abgeschrittene Feld</translation>
    </message>
    <message>
        <source>The mask</source>
        <translation>Die Maske</translation>
    </message>
    <message>
        <source>the mask is made of the occluders</source>
        <translation>die Maske wird aus den Verdeckern gemacht</translation>
    </message>
    <message>
        <source>the mask is shown</source>
        <translation>die Maske wird gezeigt</translation>
    </message>
    <message>
        <source>the median is not in this interval; correct it there.</source>
        <translation>der Median liegt nicht in diesem Intervall; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>The mesh is not closed or no manifold ({1} edges, {2} vertices, {3} triangles); nothing was written. Give a slightly different --cell.</source>
        <translation>Das Netz ist nicht geschlossen oder keine Mannigfaltigkeit ({1} Kanten, {2} Ecken, {3} Dreiecke); nichts wurde geschrieben. Geben Sie ein etwas anderes --cell an.</translation>
    </message>
    <message>
        <source>the model has more than 200,000 triangles, too many for fins; a march fills its silhouette as well</source>
        <translation>das Modell hat mehr als 200 000 Dreiecke, zu viele für Fins; ein Raymarching füllt seine Silhouette ebenso</translation>
    </message>
    <message>
        <source>the model has no animation</source>
        <translation>das Modell hat keine Animation</translation>
    </message>
    <message>
        <source>the moon has set</source>
        <translation>der Mond ist untergegangen</translation>
    </message>
    <message>
        <source>The museum</source>
        <translation>Das Museum</translation>
    </message>
    <message>
        <source>The museum itself: its sun, its sky, its reflections and the exposure of the picture.</source>
        <translation>Das Museum selbst: seine Sonne, sein Himmel, seine Spiegelungen und die Belichtung des Bildes.</translation>
    </message>
    <message>
        <source>the name of a choice</source>
        <translation>der Name einer Auswahl</translation>
    </message>
    <message>
        <source>the new content is in place, but the disk did not confirm it ({1}); save once more.</source>
        <translation>der neue Inhalt steht an seinem Platz, aber der Datenträger hat ihn nicht bestätigt ({=1}); speichern Sie noch einmal.</translation>
    </message>
    <message>
        <source>the next motion starts from the idle picture</source>
        <translation>die nächste Bewegung beginnt mit dem ruhenden Bild</translation>
    </message>
    <message>
        <source>The night sky stays until it can be read.</source>
        <translation>Der Nachthimmel bleibt, bis es gelesen werden kann.</translation>
    </message>
    <message>
        <source>the normal is 0, 0, 0; give a direction</source>
        <translation>die Normale ist 0, 0, 0; geben Sie eine Richtung an</translation>
    </message>
    <message>
        <source>the number {1} is too large; numbers end at 1.8e308</source>
        <translation>die Zahl {=1} ist zu groß; Zahlen enden bei 1.8e308</translation>
    </message>
    <message>
        <source>The object covers at most {1} pixels of a frame: it moves far in its animation, or a frame is small. Take its motion out of the frames, or make them larger.</source>
        <translation>Das Objekt bedeckt höchstens {1} Pixel eines Frames: Es bewegt sich weit in seiner Animation, oder ein Frame ist klein. Nehmen Sie seine Bewegung aus den Frames, oder machen Sie sie größer.</translation>
    </message>
    <message>
        <source>The object itself, ray by ray, beside what stands in its place.</source>
        <translation>Das Objekt selbst, Strahl für Strahl, neben dem, was an seiner Stelle steht.</translation>
    </message>
    <message>
        <source>the objects on the floor have changed</source>
        <translation>die Objekte auf dem Boden haben sich geändert</translation>
    </message>
    <message>
        <source>The other's cost at this error</source>
        <translation>Kosten der anderen bei diesem Fehler</translation>
    </message>
    <message>
        <source>The other's error at this cost</source>
        <translation>Fehler der anderen bei diesen Kosten</translation>
    </message>
    <message>
        <source>the overlay is on</source>
        <translation>die Überlagerung ist eingeschaltet</translation>
    </message>
    <message>
        <source>the overlay is on; the box clips the object</source>
        <translation>die Überlagerung ist eingeschaltet; der Quader beschneidet das Objekt</translation>
    </message>
    <message>
        <source>the overlay is switched off</source>
        <translation>die Überlagerung ist ausgeschaltet</translation>
    </message>
    <message>
        <source>the phase is {1}; give a part of a lens, 0 to 1</source>
        <translation>die Phase ist {1}; geben Sie einen Teil einer Linse an, 0 bis 1</translation>
    </message>
    <message>
        <source>the picture has {1} channels and this format holds {2}; choose OpenEXR</source>
        <translation>das Bild hat {1} Kanäle, und dieses Format fasst {2}; wählen Sie OpenEXR</translation>
    </message>
    <message>
        <source>the picture is a tile and does not show the whole sky</source>
        <translation>das Bild ist eine Kachel und zeigt nicht den ganzen Himmel</translation>
    </message>
    <message>
        <source>the picture is a tile, which cannot read the passes of its neighbors; one loop replaces them</source>
        <translation>das Bild ist eine Kachel und kann nicht in die Passes ihrer Nachbarn sehen; eine Schleife ersetzt sie</translation>
    </message>
    <message>
        <source>the picture is empty</source>
        <translation>das Bild ist leer</translation>
    </message>
    <message>
        <source>the picture is not divided</source>
        <translation>das Bild ist nicht geteilt</translation>
    </message>
    <message>
        <source>The picture is on the clipboard, %1 × %2 pixels.</source>
        <translation>Das Bild liegt in der Zwischenablage, %1 × %2 Pixel.</translation>
    </message>
    <message>
        <source>the picture moves</source>
        <translation>das Bild bewegt sich</translation>
    </message>
    <message>
        <source>the picture was abandoned</source>
        <translation>das Bild wurde aufgegeben</translation>
    </message>
    <message>
        <source>the picture was cut</source>
        <translation>das Bild wurde geschnitten</translation>
    </message>
    <message>
        <source>The picture. W A S D walk, Ctrl and the arrows look around, Enter visits.</source>
        <translation>Das Bild. W A S D gehen, Strg mit den Pfeiltasten schaut sich um, Eingabe besucht.</translation>
    </message>
    <message>
        <source>The pictures are not shaped as the print is: {1} % of its height stays white.</source>
        <translation>Die Bilder haben nicht das Format des Drucks: {1} % seiner Höhe bleiben weiß.</translation>
    </message>
    <message>
        <source>The pictures are not shaped as the print is: {1} % of its width stays white.</source>
        <translation>Die Bilder haben nicht das Format des Drucks: {1} % seiner Breite bleiben weiß.</translation>
    </message>
    <message>
        <source>The pictures are not shaped as the print is: {1} % of their height is cut off.</source>
        <translation>Die Bilder haben nicht das Format des Drucks: {1} % ihrer Höhe werden abgeschnitten.</translation>
    </message>
    <message>
        <source>The pictures are not shaped as the print is: {1} % of their width is cut off.</source>
        <translation>Die Bilder haben nicht das Format des Drucks: {1} % ihrer Breite werden abgeschnitten.</translation>
    </message>
    <message>
        <source>The pictures have different color profiles; all are converted to sRGB.</source>
        <translation>Die Bilder haben verschiedene Farbprofile; alle werden in sRGB umgerechnet.</translation>
    </message>
    <message>
        <source>The pictures of this study were not kept, its numbers were: pictures of studies with names in {1} take all the room that there is; delete one of those.</source>
        <translation>Die Bilder dieser Studie wurden nicht aufgehoben, ihre Zahlen schon: Bilder von Studien mit Namen in {1} nehmen allen Platz ein, den es gibt; löschen Sie eine von ihnen.</translation>
    </message>
    <message>
        <source>the pictures together are larger than {1} bytes; simplify the model.</source>
        <translation>die Bilder sind zusammen größer als {1} Bytes; vereinfachen Sie das Modell.</translation>
    </message>
    <message>
        <source>The polar grid has at most 4096 cells a side: four for each of 1024 samples.</source>
        <translation>Das Polargitter hat höchstens 4096 Zellen je Seite: vier für jedes von 1024 Samples.</translation>
    </message>
    <message>
        <source>The preferences could not be saved to %1. They are kept until the program ends.</source>
        <translation>Die Programmeinstellungen konnten nicht in %1 gespeichert werden. Sie gelten, bis das Programm endet.</translation>
    </message>
    <message>
        <source>The preferences in %1 could not be read: %2. They were reset to their defaults.</source>
        <translation>Die Programmeinstellungen in %1 konnten nicht gelesen werden: %2. Sie wurden auf ihre Ausgangswerte zurückgesetzt.</translation>
    </message>
    <message>
        <source>The preferences in %1 could not be read: %2. They were reset to their defaults; the file was kept as %3.</source>
        <translation>Die Programmeinstellungen in %1 konnten nicht gelesen werden: %2. Sie wurden auf ihre Ausgangswerte zurückgesetzt; die Datei wurde als %3 aufbewahrt.</translation>
    </message>
    <message>
        <source>The preview shows a part of it.</source>
        <translation>Die Vorschau zeigt einen Teil davon.</translation>
    </message>
    <message>
        <source>The print has {1} x {2} pixels, and its description says {3} x {4}; look at the unscaled, uncut file.</source>
        <translation>Der Druck hat {1} x {2} Pixel, und seine Beschreibung nennt {3} x {4}; sehen Sie die unskalierte, unbeschnittene Datei an.</translation>
    </message>
    <message>
        <source>The print is laid out for {1} views, and there are {2}.</source>
        <translation>Der Druck ist für {1} Ansichten angelegt, und es gibt {2}.</translation>
    </message>
    <message>
        <source>The print {1} has {2} x {3} pixels, and its description says {4} x {5}; look at the unscaled, uncut file, or at all its tiles.</source>
        <translation>Der Druck {=1} hat {2} x {3} Pixel, und seine Beschreibung nennt {4} x {5}; sehen Sie die unskalierte, unbeschnittene Datei an, oder alle ihre Kacheln.</translation>
    </message>
    <message>
        <source>the print's description</source>
        <translation>die Beschreibung des Drucks</translation>
    </message>
    <message>
        <source>The program's assets were not found beside it (looked last in {1}); reinstall it, or set VITRINE_ASSETS to the folder that holds models/materials.json.</source>
        <translation>Die Assets des Programms wurden neben ihm nicht gefunden (zuletzt gesucht in {=1}); installieren Sie es neu, oder setzen Sie VITRINE_ASSETS auf den Ordner, der models/materials.json enthält.</translation>
    </message>
    <message>
        <source>The quilt of {1} x {2} pixels does not divide into {3} x {4} views; they have {5} x {6} pixels, and a margin of {7} x {8} pixels at the edges is left out.</source>
        <translation>Der Quilt von {1} x {2} Pixeln teilt sich nicht in {3} x {4} Ansichten; sie haben {5} x {6} Pixel, und ein Rand von {7} x {8} Pixeln fällt weg.</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>der Radius</translation>
    </message>
    <message>
        <source>The rasterized mesh</source>
        <translation>Das rasterisierte Netz</translation>
    </message>
    <message>
        <source>the reference has no glass</source>
        <translation>die Referenz hat kein Glas</translation>
    </message>
    <message>
        <source>The reference is exact by the meaning of the parameter.</source>
        <translation>Die Referenz ist nach der Bedeutung des Parameters exakt.</translation>
    </message>
    <message>
        <source>The reference is the picture at rest, whose own error is not checked.</source>
        <translation>Die Referenz ist das ruhende Bild, dessen eigener Fehler nicht geprüft wird.</translation>
    </message>
    <message>
        <source>the reference shows no lamps</source>
        <translation>die Referenz zeigt keine Lampen</translation>
    </message>
    <message>
        <source>The reference to the picture {1} is not followed: {2}.</source>
        <translation>Dem Verweis auf das Bild {1} wird nicht gefolgt: {2}.</translation>
    </message>
    <message>
        <source>The reference was made twice as exact {1} time, the last time changing it by {2}</source>
        <translation>Die Referenz wurde {1}-mal doppelt so genau gemacht, was sie zuletzt um {2} änderte</translation>
    </message>
    <message>
        <source>The reference was made twice as exact {1} times, the last time changing it by {2}</source>
        <translation>Die Referenz wurde {1}-mal doppelt so genau gemacht, was sie zuletzt um {2} änderte</translation>
    </message>
    <message>
        <source>the reflection probe is switched off</source>
        <translation>die Reflexionssonde ist ausgeschaltet</translation>
    </message>
    <message>
        <source>the refractive index is {1}; plastics have 1.49 to 1.6, and it must be above 1</source>
        <translation>der Brechungsindex ist {1}; Kunststoffe haben 1.49 bis 1.6, und er muss über 1 liegen</translation>
    </message>
    <message>
        <source>The ring is shown in its place until it can be read.</source>
        <translation>Der Ring wird an seiner Stelle gezeigt, bis es gelesen werden kann.</translation>
    </message>
    <message>
        <source>The root cannot be deleted, a scene shows something; change its kind.</source>
        <translation>Die Wurzel kann nicht gelöscht werden, eine Szene zeigt etwas; ändern Sie ihre Art.</translation>
    </message>
    <message>
        <source>The rows end before lanterns look so narrow.</source>
        <translation>Die Reihen enden, bevor Laternen so schmal aussehen.</translation>
    </message>
    <message>
        <source>the same in both</source>
        <translation>in beiden gleich</translation>
    </message>
    <message>
        <source>The same with what is in the middle of the picture</source>
        <translation>Dasselbe mit dem, was in der Mitte des Bildes ist</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>die Szene</translation>
    </message>
    <message>
        <source>The scene asks for fewer mirror images of mirror images.</source>
        <translation>Die Szene verlangt weniger Spiegelbilder von Spiegelbildern.</translation>
    </message>
    <message>
        <source>the scene has more than {1} nodes, counting what instances and includes bring; leave some out</source>
        <translation>die Szene hat mehr als {1} Knoten, mitgezählt, was Instanzen und Einbindungen bringen; lassen Sie einige weg</translation>
    </message>
    <message>
        <source>the scene has no end, so no cells hold it</source>
        <translation>die Szene hat kein Ende, daher fassen sie keine Zellen</translation>
    </message>
    <message>
        <source>The scene has no end: {1}. Say with --low and --high what part of it is to be meshed.</source>
        <translation>Die Szene hat kein Ende: {1}. Geben Sie mit --low und --high an, welcher Teil vernetzt werden soll.</translation>
    </message>
    <message>
        <source>the scene has no lights</source>
        <translation>die Szene hat keine Lichter</translation>
    </message>
    <message>
        <source>The scene has {1} lights; the first {2} shine.</source>
        <translation>Die Szene hat {1} Lichter; die ersten {2} leuchten.</translation>
    </message>
    <message>
        <source>the scene includes more than {1} files; join some</source>
        <translation>die Szene bindet mehr als {1} Dateien ein; fassen Sie einige zusammen</translation>
    </message>
    <message>
        <source>The scene reaches from {1} to {2}, and the print holds {3} to {4} without doubled contours: what lies beyond will show steps. A baseline scale of {5} holds all of it.</source>
        <translation>Die Szene reicht von {1} bis {2}, und der Druck fasst {3} bis {4} ohne doppelte Konturen: Was darüber hinausgeht, wird Stufen zeigen. Ein Maßstab der Basis von {5} fasst alles.</translation>
    </message>
    <message>
        <source>the screen shows less than the eye sees</source>
        <translation>der Bildschirm zeigt weniger, als das Auge sieht</translation>
    </message>
    <message>
        <source>the selected technique does not make them</source>
        <translation>die gewählte Technik erzeugt sie nicht</translation>
    </message>
    <message>
        <source>the shadow method is none</source>
        <translation>das Schattenverfahren ist „keines“</translation>
    </message>
    <message>
        <source>The share of a frame's time for which it is exposed, by eight pictures; 0: none.</source>
        <translation>Der Anteil der Dauer eines Frames, in dem belichtet wird, durch acht Bilder; 0: keiner.</translation>
    </message>
    <message>
        <source>The sheet &quot;{1}&quot; cannot be: {2}.</source>
        <translation>Die Folie „{1}“ kann nicht sein: {2}.</translation>
    </message>
    <message>
        <source>The sheet cannot be: {1}.</source>
        <translation>Die Folie kann nicht sein: {1}.</translation>
    </message>
    <message>
        <source>The sheet would be more than 16384 pixels wide or high; ask for fewer or smaller frames.</source>
        <translation>Das Blatt wäre mehr als 16384 Pixel breit oder hoch; verlangen Sie weniger oder kleinere Frames.</translation>
    </message>
    <message>
        <source>The sheet would have more than 67 million pixels; ask for fewer or smaller frames.</source>
        <translation>Das Blatt hätte mehr als 67 Millionen Pixel; verlangen Sie weniger oder kleinere Frames.</translation>
    </message>
    <message>
        <source>The sheet {1} is {2} mm thick and its lenses have a radius of {3} mm: it cannot show views to different directions; choose a thicker sheet.</source>
        <translation>Die Folie {=1} ist {2} mm dick, und ihre Linsen haben einen Radius von {3} mm: Sie kann keine Ansichten in verschiedene Richtungen zeigen; wählen Sie eine dickere Folie.</translation>
    </message>
    <message>
        <source>The shortcut is removed from the other command.</source>
        <translation>Das Tastenkürzel wird dem anderen Befehl genommen.</translation>
    </message>
    <message>
        <source>the size of the picture changed</source>
        <translation>die Größe des Bildes hat sich geändert</translation>
    </message>
    <message>
        <source>the sky is in view</source>
        <translation>der Himmel ist im Blick</translation>
    </message>
    <message>
        <source>the sky shines into the picture</source>
        <translation>der Himmel scheint ins Bild</translation>
    </message>
    <message>
        <source>The small world is shown in its place.</source>
        <translation>An seiner Stelle wird die kleine Welt gezeigt.</translation>
    </message>
    <message>
        <source>the socket cannot be used ({1}).</source>
        <translation>Der Socket lässt sich nicht verwenden ({1}).</translation>
    </message>
    <message>
        <source>The span of a pitch chart must lie between 0 and 50 %.</source>
        <translation>Die Spanne eines Pitch-Testcharts muss zwischen 0 und 50 % liegen.</translation>
    </message>
    <message>
        <source>the speed of the model's animation is 0</source>
        <translation>die Geschwindigkeit der Animation des Modells ist 0</translation>
    </message>
    <message>
        <source>The sprite from all its sides. The cross is its pivot.</source>
        <translation>Der Sprite von all seinen Seiten. Das Kreuz ist sein Drehpunkt.</translation>
    </message>
    <message>
        <source>the strength of the beams is 0</source>
        <translation>die Stärke der Strahlen ist 0</translation>
    </message>
    <message>
        <source>the strength of the lamps is 0</source>
        <translation>die Stärke der Lampen ist 0</translation>
    </message>
    <message>
        <source>the strength of the moon is 0</source>
        <translation>die Stärke des Mondes ist 0</translation>
    </message>
    <message>
        <source>the study</source>
        <translation>die Studie</translation>
    </message>
    <message>
        <source>The study was stopped before its settings were timed.</source>
        <translation>Die Studie wurde angehalten, bevor die Zeiten ihrer Einstellungen gemessen waren.</translation>
    </message>
    <message>
        <source>the sun does not reach it through window or oculus</source>
        <translation>die Sonne erreicht es weder durch Fenster noch durch Oculus</translation>
    </message>
    <message>
        <source>the sun has moved</source>
        <translation>die Sonne ist gewandert</translation>
    </message>
    <message>
        <source>the sun has no light of the color of the tint</source>
        <translation>die Sonne hat kein Licht von der Farbe der Tönung</translation>
    </message>
    <message>
        <source>the sun has set</source>
        <translation>die Sonne ist untergegangen</translation>
    </message>
    <message>
        <source>the sun is not in front of the camera</source>
        <translation>die Sonne steht nicht vor der Kamera</translation>
    </message>
    <message>
        <source>the sun is too far beyond the picture's edge</source>
        <translation>die Sonne steht zu weit außerhalb des Bildrandes</translation>
    </message>
    <message>
        <source>the sun is too high for lamps</source>
        <translation>die Sonne steht zu hoch für Lampen</translation>
    </message>
    <message>
        <source>the sun or the walls have changed</source>
        <translation>die Sonne oder die Wände haben sich geändert</translation>
    </message>
    <message>
        <source>the sun reaches it and its shadow may be seen</source>
        <translation>die Sonne erreicht es, und sein Schatten könnte zu sehen sein</translation>
    </message>
    <message>
        <source>the sun's beams are in view</source>
        <translation>die Strahlen der Sonne sind im Blick</translation>
    </message>
    <message>
        <source>the sun's strength is 0</source>
        <translation>die Stärke der Sonne ist 0</translation>
    </message>
    <message>
        <source>the table of --manual</source>
        <translation>der Tabelle von --manual</translation>
    </message>
    <message>
        <source>the text below this heading has {1} bytes and the strip has room for {2}; shorten it, or make two steps of it.</source>
        <translation>der Text unter dieser Überschrift hat {1} Bytes, und die Leiste hat Platz für {2}; kürzen Sie ihn, oder machen Sie zwei Schritte daraus.</translation>
    </message>
    <message>
        <source>the text with its numbers is still being written</source>
        <translation>der Text mit seinen Zahlen wird noch geschrieben</translation>
    </message>
    <message>
        <source>the thickness</source>
        <translation>die Dicke</translation>
    </message>
    <message>
        <source>the three formats are little-endian</source>
        <translation>die drei Formate sind little-endian</translation>
    </message>
    <message>
        <source>the time is no number, or lies before the press of the button; the bodies are shown at rest until it is right</source>
        <translation>die Zeit ist keine Zahl oder liegt vor dem Druck auf den Knopf; die Körper werden in Ruhe gezeigt, bis sie stimmt</translation>
    </message>
    <message>
        <source>the tint of the rays is black</source>
        <translation>die Tönung der Strahlen ist schwarz</translation>
    </message>
    <message>
        <source>the torus over its pillar</source>
        <translation>dem Torus über seiner Säule</translation>
    </message>
    <message>
        <source>the torus, nearly edge-on</source>
        <translation>der Torus, fast von der Kante</translation>
    </message>
    <message>
        <source>the tour is of a newer Vitrine (version {1}, this one reads {2}); update Vitrine.</source>
        <translation>der Rundgang stammt von einem neueren Vitrine (Version {1}, dieses liest {2}); aktualisieren Sie Vitrine.</translation>
    </message>
    <message>
        <source>the tree is nested too deep for lists</source>
        <translation>der Baum ist für Listen zu tief verschachtelt</translation>
    </message>
    <message>
        <source>The turn is not finite; give an angle.</source>
        <translation>Die Drehung ist nicht endlich; geben Sie einen Winkel an.</translation>
    </message>
    <message>
        <source>The twelve edges of a box.</source>
        <translation>Die zwölf Kanten eines Quaders.</translation>
    </message>
    <message>
        <source>the values of a job must be an object; correct it there.</source>
        <translation>die Werte eines Auftrags müssen ein Objekt sein; berichtigen Sie das dort.</translation>
    </message>
    <message>
        <source>The vertex attribute {1} is not supported and was ignored.</source>
        <translation>Das Vertexattribut {=1} wird nicht unterstützt und wurde übergangen.</translation>
    </message>
    <message>
        <source>the viewing distance is {1} mm; the eye must be farther away than the sheet is thick, {2} mm</source>
        <translation>der Betrachtungsabstand ist {1} mm; das Auge muss weiter weg sein, als die Folie dick ist, {2} mm</translation>
    </message>
    <message>
        <source>The views are not shaped as the print is and are stretched to it.</source>
        <translation>Die Ansichten haben nicht das Format des Drucks und werden darauf gestreckt.</translation>
    </message>
    <message>
        <source>The views come from one place: give only one of --views, --quilt and --exhibit.</source>
        <translation>Die Ansichten kommen aus einer Quelle: Geben Sie nur eines von --views, --quilt und --exhibit an.</translation>
    </message>
    <message>
        <source>The views differ in size; each is scaled to the print.</source>
        <translation>Die Ansichten sind verschieden groß; jede wird auf den Druck skaliert.</translation>
    </message>
    <message>
        <source>The visited exhibit has no table of measurements; the Study panel measures its parameters.</source>
        <translation>Das besuchte Exponat hat keine Messtabelle; das Bedienfeld „Studie“ misst seine Parameter.</translation>
    </message>
    <message>
        <source>The visited exhibit has no tree.</source>
        <translation>Das besuchte Exponat hat keinen Baum.</translation>
    </message>
    <message>
        <source>the visual LPI is {1}; give lenses per inch, or 0 to let the viewing distance decide</source>
        <translation>der visuelle LPI-Wert ist {1}; geben Sie Linsen pro Zoll an, oder 0, um den Betrachtungsabstand entscheiden zu lassen</translation>
    </message>
    <message>
        <source>The visual LPI {1} is far from the sheet's {2}.</source>
        <translation>Der visuelle LPI-Wert {1} liegt weit von dem der Folie, {2}.</translation>
    </message>
    <message>
        <source>the waffle, from below</source>
        <translation>die Waffel, von unten</translation>
    </message>
    <message>
        <source>the water</source>
        <extracomment>tables</extracomment>
        <translation>das Wasser</translation>
    </message>
    <message>
        <source>the water is flat and is hit in one step</source>
        <translation>das Wasser ist glatt und wird in einem Schritt getroffen</translation>
    </message>
    <message>
        <source>the water reflects too little moonlight to show shadows</source>
        <translation>das Wasser wirft zu wenig Mondlicht zurück, um Schatten zu zeigen</translation>
    </message>
    <message>
        <source>the weight of the rays is 0</source>
        <translation>das Gewicht der Strahlen ist 0</translation>
    </message>
    <message>
        <source>the width</source>
        <translation>die Breite</translation>
    </message>
    <message>
        <source>the window opens, and others come first</source>
        <translation>das Fenster öffnet sich, und andere kommen zuerst</translation>
    </message>
    <message>
        <source>the written file cannot be opened ({1})</source>
        <translation>die geschriebene Datei lässt sich nicht öffnen ({=1})</translation>
    </message>
    <message>
        <source>the written file has another resolution</source>
        <translation>die geschriebene Datei hat eine andere Auflösung</translation>
    </message>
    <message>
        <source>the written file has another size</source>
        <translation>die geschriebene Datei hat eine andere Größe</translation>
    </message>
    <message>
        <source>the {1} in line {2} of {3} goes on without end</source>
        <translation>{=1} in Zeile {2} von {=3} hat kein Ende</translation>
    </message>
    <message>
        <source>the {1} in line {2} of {3} is stretched too much to have a bound within what is blended, rounded or displaced around it</source>
        <translation>{=1} in Zeile {2} von {=3} ist zu stark gestreckt, um innerhalb dessen, was darum verschmolzen, gerundet oder verschoben ist, eine Schranke zu haben</translation>
    </message>
    <message>
        <source>the {1} is less than a pixel</source>
        <translation>Zu klein: {1} misst weniger als ein Pixel</translation>
    </message>
    <message>
        <source>The {1} is missing and is left out.</source>
        <translation>Es fehlt und wird weggelassen: {1}.</translation>
    </message>
    <message>
        <source>the {1} is {2} pixels; picture files end at 2147483647</source>
        <translation>Zu groß: {1} misst {2} Pixel; Bilddateien enden bei 2147483647</translation>
    </message>
    <message>
        <source>Their pictures are of different sizes, so their times cannot be compared: their work per pixel is.</source>
        <translation>Ihre Bilder sind verschieden groß, daher lassen sich ihre Zeiten nicht vergleichen: Verglichen wird ihre Arbeit pro Pixel.</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Theme, size of type, motion, mouse, what a picture may cost, keys, recent files.</source>
        <translation>Farbschema, Schriftgröße, Bewegung, Maus, was ein Bild kosten darf, Tasten, zuletzt geöffnete Dateien.</translation>
    </message>
    <message>
        <source>there are more than 16 lights; leave some out</source>
        <translation>es gibt mehr als 16 Lichter; lassen Sie einige weg</translation>
    </message>
    <message>
        <source>there are more than {1} indices</source>
        <translation>es gibt mehr als {1} Indizes</translation>
    </message>
    <message>
        <source>there are more than {1} primitives</source>
        <translation>es gibt mehr als {1} Primitive</translation>
    </message>
    <message>
        <source>there are more than {1} vertices</source>
        <translation>es gibt mehr als {1} Ecken</translation>
    </message>
    <message>
        <source>there are no beams to add to the picture</source>
        <translation>es gibt keine Strahlen, die zum Bild zu addieren wären</translation>
    </message>
    <message>
        <source>There are no bookmarks yet.</source>
        <translation>Es gibt noch keine Lesezeichen.</translation>
    </message>
    <message>
        <source>There are no pictures in {1}; give a folder with the views as {2}.</source>
        <translation>In {1} sind keine Bilder; geben Sie einen Ordner mit den Ansichten als {2} an.</translation>
    </message>
    <message>
        <source>there are no rows</source>
        <translation>es gibt keine Zeilen</translation>
    </message>
    <message>
        <source>There are no unsaved edits in the tree.</source>
        <translation>Im Baum gibt es keine ungespeicherten Änderungen.</translation>
    </message>
    <message>
        <source>there are no views</source>
        <translation>es gibt keine Ansichten</translation>
    </message>
    <message>
        <source>There are no views; choose a folder or pictures.</source>
        <translation>Es gibt keine Ansichten; wählen Sie einen Ordner oder Bilder.</translation>
    </message>
    <message>
        <source>There are no views; give a folder or files with --views.</source>
        <translation>Es gibt keine Ansichten; geben Sie mit --views einen Ordner oder Dateien an.</translation>
    </message>
    <message>
        <source>There are no views; give pictures with --views or --quilt, or an --exhibit.</source>
        <translation>Es gibt keine Ansichten; geben Sie mit --views oder --quilt Bilder an, oder mit --exhibit ein Exponat.</translation>
    </message>
    <message>
        <source>there are too few; export the file again.</source>
        <translation>es sind zu wenige; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>there are {1} views, and {2} is the most</source>
        <translation>es gibt {1} Ansichten, und {2} sind das Höchste</translation>
    </message>
    <message>
        <source>There are {1} views, and {2} is the most; take fewer with --every {3} or --count {4}.</source>
        <translation>Es gibt {1} Ansichten, und {2} sind das Höchste; nehmen Sie weniger, mit --every {3} oder --count {4}.</translation>
    </message>
    <message>
        <source>there are {1}, more than the {2} allowed; simplify the model.</source>
        <translation>es sind {1}, mehr als die erlaubten {2}; vereinfachen Sie das Modell.</translation>
    </message>
    <message>
        <source>there is a block under this heading already; put both into one.</source>
        <translation>unter dieser Überschrift steht bereits ein Block; legen Sie beide zusammen.</translation>
    </message>
    <message>
        <source>There is neither a file nor a preset of {1} named {2} its presets are {3}</source>
        <translation>Es gibt weder eine Datei noch ein Preset von {=1} namens {2} die Presets sind {=3}</translation>
    </message>
    <message>
        <source>There is neither a file nor a preset of {1} named {2}; give a preset file.</source>
        <translation>Es gibt weder eine Datei noch ein Preset von {=1} namens {=2}; geben Sie eine Preset-Datei an.</translation>
    </message>
    <message>
        <source>There is no animation &quot;{1}&quot;; the file has none.</source>
        <translation>Eine Animation „{=1}“ gibt es nicht; die Datei hat keine.</translation>
    </message>
    <message>
        <source>There is no animation &quot;{1}&quot;; the file has {2}.</source>
        <translation>Eine Animation „{=1}“ gibt es nicht; die Datei hat {=2}.</translation>
    </message>
    <message>
        <source>there is no background behind the air</source>
        <translation>hinter der Luft ist kein Hintergrund</translation>
    </message>
    <message>
        <source>There is no bookmark %1 yet: Bookmarks &gt; Set bookmark %1 makes one of where you are.</source>
        <translation>Ein Lesezeichen %1 gibt es noch nicht: Lesezeichen &gt; Lesezeichen %1 setzen macht eines von dort, wo Sie sind.</translation>
    </message>
    <message>
        <source>There is no earlier position to return to.</source>
        <translation>Es gibt keine frühere Position.</translation>
    </message>
    <message>
        <source>There is no exhibit &quot;{1} `vitrine list` names them.</source>
        <translation>Kein Exponat heißt &quot;{1} `vitrine list` nennt alle.</translation>
    </message>
    <message>
        <source>There is no exhibit in the middle of the picture.</source>
        <translation>In der Bildmitte ist kein Exponat.</translation>
    </message>
    <message>
        <source>there is no exhibit of that name; `vitrine list` names them.</source>
        <translation>ein Exponat dieses Namens gibt es nicht; `vitrine list` nennt sie.</translation>
    </message>
    <message>
        <source>There is no exhibit “%1” here, so its numbers are shown, but cannot be applied.</source>
        <translation>Ein Exponat „%1“ gibt es hier nicht, daher werden seine Zahlen gezeigt, lassen sich aber nicht anwenden.</translation>
    </message>
    <message>
        <source>There is no folder for temporary files ({1}); let TMPDIR name one that you may write to.</source>
        <translation>Es gibt keinen Ordner für temporäre Dateien ({=1}); lassen Sie TMPDIR einen nennen, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>there is no hall</source>
        <translation>es gibt keine Halle</translation>
    </message>
    <message>
        <source>there is no hall to bounce it</source>
        <translation>es gibt keine Halle, die es zurückwirft</translation>
    </message>
    <message>
        <source>there is no hall to cast it</source>
        <translation>es gibt keine Halle, die ihn wirft</translation>
    </message>
    <message>
        <source>There is no kind of node &quot;{1}&quot;.</source>
        <translation>Eine Knotenart „{=1}“ gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no lesson about this exhibit.</source>
        <translation>Zu diesem Exponat gibt es keine Lektion.</translation>
    </message>
    <message>
        <source>there is no light to reflect</source>
        <translation>es gibt kein Licht zu spiegeln</translation>
    </message>
    <message>
        <source>There is no node {1} any more; choose another one.</source>
        <translation>Einen Knoten {=1} gibt es nicht mehr; wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>there is no parameter &quot;{1}&quot;; `vitrine list --manual {2}` names those of {3}.</source>
        <translation>einen Parameter „{=1}“ gibt es nicht; `vitrine list --manual {=2}` nennt die von {=3}.</translation>
    </message>
    <message>
        <source>There is no parameter “%1” now, so its numbers are shown, but cannot be applied.</source>
        <translation>Einen Parameter „%1“ gibt es jetzt nicht, daher werden seine Zahlen gezeigt, lassen sich aber nicht anwenden.</translation>
    </message>
    <message>
        <source>there is no parameter; it is no study that Vitrine wrote.</source>
        <translation>es gibt keinen Parameter; das ist keine Studie, die Vitrine geschrieben hat.</translation>
    </message>
    <message>
        <source>there is no point; nothing was measured.</source>
        <translation>es gibt keinen Punkt; nichts wurde gemessen.</translation>
    </message>
    <message>
        <source>There is no print yet.</source>
        <translation>Es gibt noch keinen Druck.</translation>
    </message>
    <message>
        <source>There is no quilt; choose a picture with a grid of views.</source>
        <translation>Es gibt keinen Quilt; wählen Sie ein Bild mit einem Raster von Ansichten.</translation>
    </message>
    <message>
        <source>There is no red button in front of you.</source>
        <translation>Vor Ihnen ist kein roter Knopf.</translation>
    </message>
    <message>
        <source>There is no sheet &quot;{1}&quot;; choose one of the list.</source>
        <translation>Eine Folie „{=1}“ gibt es nicht; wählen Sie eine aus der Liste.</translation>
    </message>
    <message>
        <source>There is no sheet &quot;{1}&quot;; known are {2}.</source>
        <translation>Eine Folie „{=1}“ gibt es nicht; bekannt sind {=2}.</translation>
    </message>
    <message>
        <source>there is no step in it; write &quot;## Title&quot; for each.</source>
        <translation>sie enthält keinen Schritt; schreiben Sie „## Titel“ für jeden.</translation>
    </message>
    <message>
        <source>there is no study; choose another file.</source>
        <translation>es gibt keine Studie; wählen Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>there is no such buffer.</source>
        <translation>einen solchen Puffer gibt es nicht.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>es gibt keine solche Datei</translation>
    </message>
    <message>
        <source>there is no such file; check the name.</source>
        <translation>eine solche Datei gibt es nicht; prüfen Sie den Namen.</translation>
    </message>
    <message>
        <source>there is no such parameter{1} remove it there.</source>
        <translation>diesen Parameter gibt es nicht{1} entfernen Sie ihn dort.</translation>
    </message>
    <message>
        <source>there is no text below this heading; write a sentence, or remove the heading.</source>
        <translation>unter dieser Überschrift steht kein Text; schreiben Sie einen Satz, oder entfernen Sie die Überschrift.</translation>
    </message>
    <message>
        <source>there is no text to show</source>
        <translation>es gibt keinen Text zu zeigen</translation>
    </message>
    <message>
        <source>there is no version {1}; correct it there.</source>
        <translation>es gibt keine Version {1}; berichtigen Sie sie dort.</translation>
    </message>
    <message>
        <source>there is no view; it is no study that Vitrine wrote.</source>
        <translation>es gibt keine Ansicht; das ist keine Studie, die Vitrine geschrieben hat.</translation>
    </message>
    <message>
        <source>there is not enough memory for fins</source>
        <translation>für Fins reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>There was not enough memory for this, and nothing was changed. Choose a smaller size, or close another program.</source>
        <translation>Der Speicher reichte dafür nicht aus, und nichts wurde geändert. Wählen Sie eine kleinere Größe, oder schließen Sie ein anderes Programm.</translation>
    </message>
    <message>
        <source>There was not enough memory for this; ask for a smaller size, or fewer samples or views.</source>
        <translation>Der Speicher reichte dafür nicht aus; verlangen Sie eine kleinere Größe, oder weniger Samples oder Ansichten.</translation>
    </message>
    <message>
        <source>these are more than {1} tags; take some away.</source>
        <translation>das sind mehr als {1} Tags; entfernen Sie einige.</translation>
    </message>
    <message>
        <source>these are more than {1}; take some away.</source>
        <translation>das sind mehr als {1}; entfernen Sie einige.</translation>
    </message>
    <message>
        <source>these are too many; take some away.</source>
        <translation>das sind zu viele; entfernen Sie einige.</translation>
    </message>
    <message>
        <source>these must rise and stay below the accessor's count</source>
        <translation>diese müssen steigen und unter der Anzahl des Accessors bleiben</translation>
    </message>
    <message>
        <source>These studies share no count of work that tells their settings apart{1}; measure them by the same counter.</source>
        <translation>Diese Studien haben keinen gemeinsamen Zählwert der Arbeit, der ihre Einstellungen unterscheidet{1}; messen Sie sie mit demselben Zähler.</translation>
    </message>
    <message>
        <source>These studies share no count of work, so no chart can show them together.</source>
        <translation>Diese Studien haben keinen gemeinsamen Zählwert der Arbeit; kein Diagramm kann sie zusammen zeigen.</translation>
    </message>
    <message>
        <source>These variations are of earlier settings or locks. “Draw anew” uses the current ones.</source>
        <translation>Diese Variationen gehören zu früheren Einstellungen oder Sperren. „Neu zeichnen“ nimmt die jetzigen.</translation>
    </message>
    <message>
        <source>they fill the gaps between shells seen from the side</source>
        <translation>sie füllen die Lücken zwischen seitlich gesehenen Shells</translation>
    </message>
    <message>
        <source>They share no count of work that tells their settings apart, so there is nothing to compare them by.</source>
        <translation>Sie haben keinen gemeinsamen Zählwert der Arbeit, der ihre Einstellungen unterscheidet, daher gibt es nichts, wonach sie sich vergleichen lassen.</translation>
    </message>
    <message>
        <source>they stand on something</source>
        <translation>sie stehen auf etwas</translation>
    </message>
    <message>
        <source>They were measured on different machines, so their times cannot be compared: their work is, which counts the same anywhere.</source>
        <translation>Sie wurden auf verschiedenen Rechnern gemessen, daher lassen sich ihre Zeiten nicht vergleichen: Verglichen wird ihre Arbeit, die überall gleich zählt.</translation>
    </message>
    <message>
        <source>They were timed by different clocks, so their times cannot be compared: their work is, which counts the same anywhere.</source>
        <translation>Ihre Zeiten wurden mit verschiedenen Uhren gemessen, daher lassen sie sich nicht vergleichen: Verglichen wird ihre Arbeit, die überall gleich zählt.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <extracomment>tables</extracomment>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness of a sprinkle.</source>
        <extracomment>tables</extracomment>
        <translation>Dicke eines Streusels.</translation>
    </message>
    <message>
        <source>Thickness of a strand at its root.</source>
        <extracomment>tables</extracomment>
        <translation>Dicke eines Haars an der Wurzel.</translation>
    </message>
    <message>
        <source>Thickness of the custom sheet from the top of a lens to the print: too thin or too thick blurs.</source>
        <extracomment>tables</extracomment>
        <translation>Dicke der eigenen Folie vom Linsenscheitel bis zum Druck: Zu dünn oder zu dick wird unscharf.</translation>
    </message>
    <message>
        <source>Thickness of the edges.</source>
        <translation>Dicke der Kanten.</translation>
    </message>
    <message>
        <source>Thickness of the paper as it is drawn.</source>
        <extracomment>tables</extracomment>
        <translation>Dicke des Papiers, wie es gezeichnet wird.</translation>
    </message>
    <message>
        <source>Thickness of the sheet, from lens top to print.</source>
        <translation>Dicke der Folie, vom Linsenscheitel bis zum Druck.</translation>
    </message>
    <message>
        <source>Thickness of the sheet, with round edges.</source>
        <translation>Dicke des Blatts, mit runden Kanten.</translation>
    </message>
    <message>
        <source>Thickness of the wall of the mug: thin walls need small steps.</source>
        <extracomment>tables</extracomment>
        <translation>Dicke der Wand der Tasse: Dünne Wände brauchen kleine Schritte.</translation>
    </message>
    <message>
        <source>Thickness of the wall.</source>
        <translation>Dicke der Wand.</translation>
    </message>
    <message>
        <source>Thickness of the wooden base.</source>
        <extracomment>tables</extracomment>
        <translation>Dicke des hölzernen Bodens.</translation>
    </message>
    <message>
        <source>Thickness variation</source>
        <extracomment>tables</extracomment>
        <translation>Dickenstreuung</translation>
    </message>
    <message>
        <source>thin bars</source>
        <extracomment>tables</extracomment>
        <translation>dünne Stäbe</translation>
    </message>
    <message>
        <source>thing</source>
        <translation>Ding</translation>
    </message>
    <message>
        <source>Third model</source>
        <extracomment>tables</extracomment>
        <translation>Modell 3</translation>
    </message>
    <message>
        <source>Third model across</source>
        <extracomment>tables</extracomment>
        <translation>Modell 3 quer</translation>
    </message>
    <message>
        <source>Third model along</source>
        <extracomment>tables</extracomment>
        <translation>Modell 3 längs</translation>
    </message>
    <message>
        <source>Third model plinth height</source>
        <extracomment>tables</extracomment>
        <translation>Sockelhöhe von Modell 3</translation>
    </message>
    <message>
        <source>Third model rotation</source>
        <extracomment>tables</extracomment>
        <translation>Drehung von Modell 3</translation>
    </message>
    <message>
        <source>Third model size</source>
        <extracomment>tables</extracomment>
        <translation>Größe von Modell 3</translation>
    </message>
    <message>
        <source>Third model stand</source>
        <extracomment>tables</extracomment>
        <translation>Stand von Modell 3</translation>
    </message>
    <message>
        <source>Third object</source>
        <extracomment>tables</extracomment>
        <translation>Drittes Objekt</translation>
    </message>
    <message>
        <source>Thirty-five solids make one ice cream; each point asks the few that decide.</source>
        <translation>Fünfunddreißig Körper sind ein Eis; jeder Punkt fragt die wenigen, die entscheiden.</translation>
    </message>
    <message>
        <source>this answer has no question; write &quot;### Question&quot; above it.</source>
        <translation>diese Antwort hat keine Frage; schreiben Sie „### Question“ darüber.</translation>
    </message>
    <message>
        <source>this block is not closed; end it with ```.</source>
        <translation>dieser Block ist nicht geschlossen; beenden Sie ihn mit ```.</translation>
    </message>
    <message>
        <source>This cannot be done.</source>
        <translation>Das geht nicht.</translation>
    </message>
    <message>
        <source>This copy of the program has no manual (README.md).</source>
        <translation>Diesem Exemplar des Programms liegt kein Handbuch (README.md) bei.</translation>
    </message>
    <message>
        <source>this data: URI is not base 64; export the file again.</source>
        <translation>dieses data:-URI ist nicht base64; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>this direction has no length; give it one.</source>
        <translation>diese Richtung hat keine Länge; geben Sie ihr eine.</translation>
    </message>
    <message>
        <source>this document is newer than the program; use a newer Vitrine.</source>
        <translation>dieses Dokument ist neuer als das Programm; nehmen Sie ein neueres Vitrine.</translation>
    </message>
    <message>
        <source>this document is not of the job {1}; give one that it wrote.</source>
        <translation>dieses Dokument ist nicht vom Auftrag {=1}; geben Sie eines an, das er geschrieben hat.</translation>
    </message>
    <message>
        <source>this does not describe a lenticular print; give a print, or the JSON beside it.</source>
        <translation>das beschreibt keinen Linsendruck; geben Sie einen Druck an, oder das JSON daneben.</translation>
    </message>
    <message>
        <source>This exhibit has no charts.</source>
        <translation>Dieses Exponat hat keine Diagramme.</translation>
    </message>
    <message>
        <source>This exhibit is made of light alone: there is nothing to cut out.</source>
        <translation>Dieses Exponat besteht nur aus Licht: Es gibt nichts freizustellen.</translation>
    </message>
    <message>
        <source>this expression gives no number; it must be {1}</source>
        <translation>dieser Ausdruck ergibt keine Zahl; hier muss {1} stehen</translation>
    </message>
    <message>
        <source>this file is not opened: {1}; name one of the scene's folder or below it</source>
        <translation>diese Datei wird nicht geöffnet: {1}; nennen Sie eine im Ordner der Szene oder darunter</translation>
    </message>
    <message>
        <source>this holds settings of the whole exhibition; open it as such.</source>
        <translation>das enthält Einstellungen der ganzen Ausstellung; öffnen Sie es als solche.</translation>
    </message>
    <message>
        <source>this holds settings of {1} and none of {2}; choose another.</source>
        <translation>dies enthält Einstellungen von {=1} und keine von {=2}; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>this is a preset of one exhibit; open it there.</source>
        <translation>das ist ein Preset eines einzelnen Exponats; öffnen Sie es dort.</translation>
    </message>
    <message>
        <source>this is binary data and not JSON; choose another file</source>
        <translation>dies sind binäre Daten und kein JSON; wählen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>this is glTF {1}, and version 2 is read; export it as glTF 2.0.</source>
        <translation>das ist glTF {=1}, und gelesen wird Version 2; exportieren Sie es als glTF 2.0.</translation>
    </message>
    <message>
        <source>this is no list of lens sheets of version 1; move it away, and a new one is begun.</source>
        <translation>das ist keine Liste von Linsenfolien der Version 1; legen Sie sie beiseite, und eine neue wird begonnen.</translation>
    </message>
    <message>
        <source>this is no preset of Vitrine: it says neither format nor version.</source>
        <translation>das ist kein Preset von Vitrine: Es nennt weder Format noch Version.</translation>
    </message>
    <message>
        <source>this is no preset: it must be a JSON object.</source>
        <translation>das ist kein Preset: Es muss ein JSON-Objekt sein.</translation>
    </message>
    <message>
        <source>this is no scene; one begins with &quot;format&quot;: &quot;{1}</source>
        <translation>das ist keine Szene; eine beginnt mit &quot;format&quot;: &quot;{=1}</translation>
    </message>
    <message>
        <source>this is no settings document of a job; give a file that a job of Vitrine wrote.</source>
        <translation>das sind keine Einstellungen eines Auftrags; geben Sie eine Datei an, die ein Auftrag von Vitrine geschrieben hat.</translation>
    </message>
    <message>
        <source>this is no study; choose a file that `vitrine study` wrote.</source>
        <translation>das ist keine Studie; wählen Sie eine Datei, die `vitrine study` geschrieben hat.</translation>
    </message>
    <message>
        <source>this is not a finite number</source>
        <translation>das ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>this is not a lesson; write &quot;vitrine-lesson&quot;.</source>
        <translation>das ist keine Lektion; schreiben Sie „vitrine-lesson“.</translation>
    </message>
    <message>
        <source>this is not valid JSON</source>
        <translation>das ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>this is not valid JSON ({1}); correct it there</source>
        <translation>das ist kein gültiges JSON ({=1}); korrigieren Sie es dort</translation>
    </message>
    <message>
        <source>this is required and missing; export the file again.</source>
        <translation>das ist nötig und fehlt; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>this is {1}; give {2}</source>
        <translation>hier steht {1}; geben Sie {2} an</translation>
    </message>
    <message>
        <source>this key appears twice; remove one of the two</source>
        <translation>dieser Schlüssel steht zweimal da; entfernen Sie einen der beiden</translation>
    </message>
    <message>
        <source>this key is longer than {1}</source>
        <translation>dieser Schlüssel ist länger als {1}</translation>
    </message>
    <message>
        <source>this key is not known here; remove it, or write one of {1}.</source>
        <translation>dieser Schlüssel ist hier nicht bekannt; entfernen Sie ihn, oder schreiben Sie einen von {=1}.</translation>
    </message>
    <message>
        <source>This kind of video keeps one color for two by two pixels and needs even sizes, and not {1}; give {2}x{3}, or choose .gif, .webp or .apng.</source>
        <translation>Diese Art von Video speichert eine Farbe für zwei mal zwei Pixel und braucht gerade Größen, und nicht {=1}; geben Sie {2}x{3} an, oder wählen Sie .gif, .webp oder .apng.</translation>
    </message>
    <message>
        <source>this lesson is of a newer Vitrine; update the program.</source>
        <translation>diese Lektion stammt von einem neueren Vitrine; aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>this machine's FFmpeg cannot read the format</source>
        <translation>das FFmpeg dieses Rechners kann dieses Format nicht lesen</translation>
    </message>
    <message>
        <source>this machine's FFmpeg has no encoder {1}</source>
        <translation>das FFmpeg dieses Rechners hat keinen Encoder {=1}</translation>
    </message>
    <message>
        <source>this matrix leaves nothing to draw; correct it there.</source>
        <translation>diese Matrix lässt nichts zu zeichnen übrig; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be </source>
        <translation>hier muss stehen: </translation>
    </message>
    <message>
        <source>this must be &quot;best&quot;, or an object with eye, target and fov.</source>
        <translation>hier muss „best“ stehen, oder ein Objekt mit eye, target und fov.</translation>
    </message>
    <message>
        <source>this must be 1 to 256; correct it there.</source>
        <translation>hier muss 1 bis 256 stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be 1 to the accessor's count</source>
        <translation>hier muss 1 bis zur Anzahl des Accessors stehen</translation>
    </message>
    <message>
        <source>this must be 1 to {1}</source>
        <translation>hier muss 1 bis {1} stehen</translation>
    </message>
    <message>
        <source>this must be 1; use the Vitrine that wrote it.</source>
        <translation>das muss 1 sein; nehmen Sie das Vitrine, das es schrieb.</translation>
    </message>
    <message>
        <source>this must be a file name; correct it there.</source>
        <translation>das muss ein Dateiname sein; berichtigen Sie das dort.</translation>
    </message>
    <message>
        <source>this must be a list of file names; correct it there.</source>
        <translation>hier muss eine Liste von Dateinamen stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be a number</source>
        <translation>hier muss eine Zahl stehen</translation>
    </message>
    <message>
        <source>this must be a number of seconds; correct it there.</source>
        <translation>dies muss eine Zahl von Sekunden sein; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be a number, or three as [x, y, z]</source>
        <translation>hier muss eine Zahl stehen, oder drei als [x, y, z]</translation>
    </message>
    <message>
        <source>this must be a number; correct it there.</source>
        <translation>hier muss eine Zahl stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be a sheet with a name; correct it there, or move the file away, and a new list is begun.</source>
        <translation>hier muss eine Folie mit einem Namen stehen; korrigieren Sie es dort, oder legen Sie die Datei beiseite, und eine neue Liste wird begonnen.</translation>
    </message>
    <message>
        <source>this must be a text in quotes</source>
        <translation>hier muss ein Text in Anführungszeichen stehen</translation>
    </message>
    <message>
        <source>this must be a whole number from 1; correct it there.</source>
        <translation>hier muss eine ganze Zahl ab 1 stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be a whole number from {1} to {2}; correct it there.</source>
        <translation>hier muss eine ganze Zahl von {1} bis {2} stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be a whole number, not {1}</source>
        <translation>hier muss eine ganze Zahl stehen, nicht {1}</translation>
    </message>
    <message>
        <source>this must be a whole number; correct it there.</source>
        <translation>hier muss eine ganze Zahl stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an array of at least one bookmark; correct it there.</source>
        <translation>hier muss ein Array mit mindestens einem Lesezeichen stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an array of names; correct it there.</source>
        <translation>dies muss ein Array aus Namen sein; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an array of texts; correct it there.</source>
        <translation>hier muss ein Array von Texten stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an array of two numbers; correct it there.</source>
        <translation>dies muss ein Array aus zwei Zahlen sein; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an array of {1} numbers</source>
        <translation>hier muss ein Array von {1} Zahlen stehen</translation>
    </message>
    <message>
        <source>this must be an array of {1} values; correct it there.</source>
        <translation>das muss eine Liste von {1} Werten sein; berichtigen Sie das dort.</translation>
    </message>
    <message>
        <source>this must be an array; correct it there.</source>
        <translation>hier muss ein Array stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an array; export the file again.</source>
        <translation>hier muss ein Array stehen; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>this must be an object; correct it there.</source>
        <translation>hier muss ein Objekt stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be an object; export the file again.</source>
        <translation>hier muss ein Objekt stehen; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>this must be an object; it is no study that Vitrine wrote.</source>
        <translation>hier muss ein Objekt stehen; das ist keine Studie, die Vitrine geschrieben hat.</translation>
    </message>
    <message>
        <source>this must be at most 1; correct it there.</source>
        <translation>hier muss höchstens 1 stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be from 0 to 1e15; correct it there.</source>
        <translation>hier muss ein Wert von 0 bis 1e15 stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be like 2026-11-25T01:43:23; correct it there.</source>
        <translation>hier muss etwas wie 2026-11-25T01:43:23 stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be text; correct it there.</source>
        <translation>hier muss Text stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be the code of a language; correct it there.</source>
        <translation>dies muss das Kürzel einer Sprache sein; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be three arrays of three numbers; correct it there.</source>
        <translation>dies müssen drei Arrays aus je drei Zahlen sein; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be three numbers: [x, y, z]</source>
        <translation>hier müssen drei Zahlen stehen: [x, y, z]</translation>
    </message>
    <message>
        <source>this must be true or false</source>
        <translation>hier muss true oder false stehen</translation>
    </message>
    <message>
        <source>this must be true or false; correct it there.</source>
        <translation>hier muss true oder false stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be two numbers; correct it there.</source>
        <translation>hier müssen zwei Zahlen stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be width and height; correct it there.</source>
        <translation>hier müssen Breite und Höhe stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be {1}</source>
        <translation>hier muss {1} stehen</translation>
    </message>
    <message>
        <source>this must be {1} numbers</source>
        <translation>hier müssen {1} Zahlen stehen</translation>
    </message>
    <message>
        <source>this must be {1}; correct it there.</source>
        <translation>hier muss {1} stehen; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>this must be {1}; export the file again.</source>
        <translation>hier muss {1} stehen; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>this must have 3 or 4 components; export the file again.</source>
        <translation>dies muss 3 oder 4 Komponenten haben; exportieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>this must have {1} components; export the file again.</source>
        <translation>hier müssen {1} Komponenten stehen; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>this must not be negative</source>
        <translation>das darf nicht negativ sein</translation>
    </message>
    <message>
        <source>this name is taken: expressions know it already; choose another</source>
        <translation>dieser Name ist vergeben: Ausdrücke kennen ihn bereits; wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>this names nothing; export the file again.</source>
        <translation>das nennt nichts; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>This node has no &quot;children&quot;; mend the file.</source>
        <translation>Dieser Knoten hat keine „children“; bessern Sie die Datei aus.</translation>
    </message>
    <message>
        <source>this node has no &quot;kind&quot;; say what it is: &quot;kind&quot;: &quot;sphere&quot;</source>
        <translation>dieser Knoten hat keine „kind“; sagen Sie, was er ist: &quot;kind&quot;: &quot;sphere&quot;</translation>
    </message>
    <message>
        <source>this node has no &quot;{1}&quot;; name what takes its place</source>
        <translation>dieser Knoten hat kein „{=1}“; nennen Sie, was an seine Stelle tritt</translation>
    </message>
    <message>
        <source>this OpenImageIO cannot read the format from memory</source>
        <translation>dieses OpenImageIO kann das Format nicht aus dem Speicher lesen</translation>
    </message>
    <message>
        <source>this OpenImageIO cannot write the format</source>
        <translation>dieses OpenImageIO kann das Format nicht schreiben</translation>
    </message>
    <message>
        <source>this OpenImageIO cannot write TIFF</source>
        <translation>dieses OpenImageIO kann kein TIFF schreiben</translation>
    </message>
    <message>
        <source>this parameter has no &quot;value&quot;; give the one it has at first</source>
        <translation>dieser Parameter hat kein „value“; geben Sie das an, was er anfangs hat</translation>
    </message>
    <message>
        <source>This place waits for an exhibit.</source>
        <translation>Dieser Platz wartet auf ein Exponat.</translation>
    </message>
    <message>
        <source>this preset is for {1}, not for {2}; choose another.</source>
        <translation>dieses Preset ist für {=1}, nicht für {=2}; wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>This print cannot be made: {1}.</source>
        <translation>Dieser Druck ist nicht möglich: {1}.</translation>
    </message>
    <message>
        <source>this question has no answer; write &quot;### Answer&quot; below it.</source>
        <translation>diese Frage hat keine Antwort; schreiben Sie „### Answer“ darunter.</translation>
    </message>
    <message>
        <source>this reference is refused because {1}; put the file beside the model and name it relatively.</source>
        <translation>dieser Verweis wird abgelehnt: {1}; legen Sie die Datei neben das Modell, und nennen Sie sie relativ.</translation>
    </message>
    <message>
        <source>this scene has no &quot;root&quot;; it is the node that is drawn</source>
        <translation>diese Szene hat keine „root“; das ist der Knoten, der gezeichnet wird</translation>
    </message>
    <message>
        <source>this scene has no shapes; give it some under &quot;primitives&quot;</source>
        <translation>diese Szene hat keine Formen; geben Sie ihr einige unter „primitives“</translation>
    </message>
    <message>
        <source>This setting was not applied: the parameter no longer accepts its value of “%1”.</source>
        <translation>Diese Einstellung wurde nicht angewendet: Der Parameter nimmt ihren Wert von „%1“ nicht mehr an.</translation>
    </message>
    <message>
        <source>This sheet is made for flips, and its lenses stand upright: each eye sees another picture. For a flip, lay them across (direction 90°).</source>
        <translation>Diese Folie ist für Wechselbilder gemacht, und ihre Linsen stehen aufrecht: Jedes Auge sieht ein anderes Bild. Legen Sie sie für einen Wechsel quer (Richtung 90°).</translation>
    </message>
    <message>
        <source>this step has &quot;### {1}&quot; already; put both into one, or make two steps.</source>
        <translation>dieser Schritt hat schon „### {=1}“; legen Sie beide zusammen, oder machen Sie zwei Schritte daraus.</translation>
    </message>
    <message>
        <source>this step has no preset; write ```json, {&quot;values&quot;: {}} and ``` below its text.</source>
        <translation>dieser Schritt hat kein Preset; schreiben Sie ```json, {&quot;values&quot;: {}} und ``` unter seinen Text.</translation>
    </message>
    <message>
        <source>this step has no text; write a sentence below its heading.</source>
        <translation>dieser Schritt hat keinen Text; schreiben Sie einen Satz unter seine Überschrift.</translation>
    </message>
    <message>
        <source>this string contains the character U+0000; remove it</source>
        <translation>diese Zeichenkette enthält das Zeichen U+0000; entfernen Sie es</translation>
    </message>
    <message>
        <source>this string is longer than {1}</source>
        <translation>diese Zeichenkette ist länger als {1}</translation>
    </message>
    <message>
        <source>This study has no times.</source>
        <translation>Diese Studie hat keine Zeiten.</translation>
    </message>
    <message>
        <source>This study was not kept: those with names in {1} take all the room that there is; delete one of them, or save this one elsewhere.</source>
        <translation>Diese Studie wurde nicht aufbewahrt: Die benannten in {=1} nehmen allen Platz ein, den es gibt; löschen Sie eine davon, oder speichern Sie diese anderswo.</translation>
    </message>
    <message>
        <source>this text is longer than {1} bytes; shorten it.</source>
        <translation>dieser Text ist länger als {1} Bytes; kürzen Sie ihn.</translation>
    </message>
    <message>
        <source>this version is not known; give &quot;version&quot;: {1}</source>
        <translation>diese Version ist nicht bekannt; geben Sie &quot;version&quot;: {1} an</translation>
    </message>
    <message>
        <source>this view reaches beyond its buffer, which has {1} bytes</source>
        <translation>diese View reicht über ihren Puffer hinaus, der {1} Bytes hat</translation>
    </message>
    <message>
        <source>this view reaches beyond its buffer.</source>
        <translation>diese View reicht über ihren Puffer hinaus.</translation>
    </message>
    <message>
        <source>this was written by a newer Vitrine; open it there.</source>
        <translation>das wurde von einem neueren Vitrine geschrieben; öffnen Sie es dort.</translation>
    </message>
    <message>
        <source>three passes</source>
        <extracomment>tables</extracomment>
        <translation>drei Passes</translation>
    </message>
    <message>
        <source>Threshold</source>
        <extracomment>tables</extracomment>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Tile width</source>
        <translation>Kachelbreite</translation>
    </message>
    <message>
        <source>Tiles of {1} mm are narrower than a lens, {2} mm.</source>
        <translation>Kacheln von {1} mm sind schmaler als eine Linse, {2} mm.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <extracomment>tables</extracomment>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Tilt of the cones: negative leans them towards the axis.</source>
        <extracomment>tables</extracomment>
        <translation>Neigung der Kegel: Negative Werte neigen sie zur Achse hin.</translation>
    </message>
    <message>
        <source>Time after a jump at which the bodies are frozen; 0 lets them move with button and clock.</source>
        <extracomment>tables</extracomment>
        <translation>Zeit nach einem Sprung, zu der die Körper eingefroren sind; 0 lässt sie sich mit Knopf und Uhr bewegen.</translation>
    </message>
    <message>
        <source>Time at which a moving scene is meshed.</source>
        <translation>Zeitpunkt, zu dem eine bewegte Szene vernetzt wird.</translation>
    </message>
    <message>
        <source>Time between automatic jumps; 0 lets the bodies jump only when the button is pressed.</source>
        <extracomment>tables</extracomment>
        <translation>Zeit zwischen selbsttätigen Sprüngen; 0 lässt die Körper nur beim Druck auf den Knopf springen.</translation>
    </message>
    <message>
        <source>time does not run</source>
        <translation>die Zeit läuft nicht</translation>
    </message>
    <message>
        <source>Time for which each stage is shown.</source>
        <extracomment>tables</extracomment>
        <translation>Zeit, für die jede Stufe gezeigt wird.</translation>
    </message>
    <message>
        <source>Time from one print to the next.</source>
        <extracomment>tables</extracomment>
        <translation>Zeit von einem Druck zum nächsten.</translation>
    </message>
    <message>
        <source>time of a picture</source>
        <translation>Zeit eines Bildes</translation>
    </message>
    <message>
        <source>Time of day</source>
        <extracomment>tables</extracomment>
        <translation>Tageszeit</translation>
    </message>
    <message>
        <source>time of day</source>
        <extracomment>tables</extracomment>
        <translation>Tageszeit</translation>
    </message>
    <message>
        <source>Time of the clock</source>
        <translation>Zeit der Uhr</translation>
    </message>
    <message>
        <source>Time of the frame</source>
        <translation>Zeit des Frames</translation>
    </message>
    <message>
        <source>Time of the frame, by %1</source>
        <translation>Zeit des Frames, nach %1</translation>
    </message>
    <message>
        <source>Time that is shown, or at which the animation starts.</source>
        <extracomment>tables</extracomment>
        <translation>Zeitpunkt, der gezeigt wird oder mit dem die Animation beginnt.</translation>
    </message>
    <message>
        <source>Time within the round that is shown, or at which the animation starts.</source>
        <extracomment>tables</extracomment>
        <translation>Zeitpunkt der Runde, der gezeigt wird oder mit dem die Animation beginnt.</translation>
    </message>
    <message>
        <source>Times of the last frames</source>
        <translation>Zeiten der letzten Frames</translation>
    </message>
    <message>
        <source>Tint</source>
        <extracomment>tables</extracomment>
        <translation>Tönung</translation>
    </message>
    <message>
        <source>Tip</source>
        <extracomment>tables</extracomment>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To the &amp;bottom</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>To the &amp;left</source>
        <translation>Nach &amp;links</translation>
    </message>
    <message>
        <source>To the &amp;right</source>
        <translation>Nach &amp;rechts</translation>
    </message>
    <message>
        <source>to the cell's wall</source>
        <extracomment>tables</extracomment>
        <translation>bis zur Zellwand</translation>
    </message>
    <message>
        <source>To {1}</source>
        <translation>Zu {1}</translation>
    </message>
    <message>
        <source>together</source>
        <extracomment>tables</extracomment>
        <translation>gemeinsam</translation>
    </message>
    <message>
        <source>too little of the sun comes in by window and oculus</source>
        <translation>durch Fenster und Oculus fällt zu wenig Sonne</translation>
    </message>
    <message>
        <source>Top radius</source>
        <translation>Radius oben</translation>
    </message>
    <message>
        <source>Tori</source>
        <translation>Tori</translation>
    </message>
    <message>
        <source>Torus to Mug</source>
        <translation>Vom Torus zur Tasse</translation>
    </message>
    <message>
        <source>Toss</source>
        <extracomment>tables</extracomment>
        <translation>Startwert des Sprungs</translation>
    </message>
    <message>
        <source>Tours (*.json)</source>
        <translation>Rundgänge (*.json)</translation>
    </message>
    <message>
        <source>Translate</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Translation of the shape.</source>
        <translation>Verschiebung der Form.</translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation>Transmission</translation>
    </message>
    <message>
        <source>Transmission: 0 is opaque, 1 is clear glass with the color of 10 cm of it.</source>
        <translation>Transmission: 0 ist undurchsichtig, 1 ist klares Glas mit der Farbe von 10 cm davon.</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triggers</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Trimmed</source>
        <translation>Beschnitten</translation>
    </message>
    <message>
        <source>Trimmed height.</source>
        <translation>Beschnittene Höhe.</translation>
    </message>
    <message>
        <source>Trimmed width.</source>
        <translation>Beschnittene Breite.</translation>
    </message>
    <message>
        <source>true</source>
        <extracomment>tables</extracomment>
        <translation>richtig</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>trusted</source>
        <translation>verlässlich</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>try another folder or disk</source>
        <translation>versuchen Sie einen anderen Ordner oder Datenträger</translation>
    </message>
    <message>
        <source>Try: build it up stage by stage, then strew sprinkles.</source>
        <translation>Probieren: Stufe um Stufe aufbauen, dann Streusel streuen.</translation>
    </message>
    <message>
        <source>Try: let the sea roll, then look at the clouds.</source>
        <translation>Probieren: das Meer rollen lassen, dann die Wolken ansehen.</translation>
    </message>
    <message>
        <source>Try: load a preset, then drag what is its own.</source>
        <translation>Probieren: ein Preset laden, dann an dem ziehen, was ihm eigen ist.</translation>
    </message>
    <message>
        <source>Try: melt it, then look for the window in its side.</source>
        <translation>Probieren: es schmelzen, dann das Fenster in seiner Seite suchen.</translation>
    </message>
    <message>
        <source>Try: press the button, then look along the backs towards the window.</source>
        <translation>Probieren: den Knopf drücken und dann über die Rücken zum Fenster schauen.</translation>
    </message>
    <message>
        <source>Try: set one free, then let the moon rise higher.</source>
        <translation>Probieren: eine freilassen, dann den Mond höher steigen lassen.</translation>
    </message>
    <message>
        <source>Try: step aside, then change the palette.</source>
        <translation>Probieren: zur Seite gehen, dann die Palette wechseln.</translation>
    </message>
    <message>
        <source>Try: walk past it, then go so near that you see its lenses.</source>
        <translation>Probieren: vorbeigehen, dann so nah heran, dass die Linsen zu sehen sind.</translation>
    </message>
    <message>
        <source>Try: walk until the banner breaks the beam.</source>
        <translation>Probieren: gehen, bis das Banner den Strahl bricht.</translation>
    </message>
    <message>
        <source>Try: {1}</source>
        <translation>Probieren: {1}</translation>
    </message>
    <message>
        <source>Tumble</source>
        <translation>Taumeln</translation>
    </message>
    <message>
        <source>turbulence</source>
        <extracomment>tables</extracomment>
        <translation>Turbulenz</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Turn of the view, clockwise</source>
        <translation>Drehung der Ansicht im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Turn or shift a view</source>
        <translation>Eine Ansicht drehen oder verschieben</translation>
    </message>
    <message>
        <source>Turn speed</source>
        <extracomment>tables</extracomment>
        <translation>Drehtempo</translation>
    </message>
    <message>
        <source>Turn step</source>
        <extracomment>tables</extracomment>
        <translation>Drehschritt</translation>
    </message>
    <message>
        <source>Turned</source>
        <extracomment>tables</extracomment>
        <translation>Zufallsdrehung</translation>
    </message>
    <message>
        <source>Twist</source>
        <extracomment>tables</extracomment>
        <translation>Verdrillung</translation>
    </message>
    <message>
        <source>Twist of the layer, in radians per meter of height: 0 is straight.</source>
        <extracomment>tables</extracomment>
        <translation>Verdrillung der Schicht, in Radiant je Meter Höhe: 0 ist gerade.</translation>
    </message>
    <message>
        <source>twisted</source>
        <extracomment>tables</extracomment>
        <translation>gedreht</translation>
    </message>
    <message>
        <source>two passes share a name</source>
        <translation>zwei Passes haben denselben Namen</translation>
    </message>
    <message>
        <source>two rows share a name</source>
        <translation>zwei Zeilen haben denselben Namen</translation>
    </message>
    <message>
        <source>Two-picture flip</source>
        <translation>Wechselbild aus zwei Bildern</translation>
    </message>
    <message>
        <source>Type a number; range: %1.</source>
        <translation>Geben Sie eine Zahl ein; Bereich: %1.</translation>
    </message>
    <message>
        <source>type of shape</source>
        <translation>Art von Form</translation>
    </message>
    <message>
        <source>Type on or off.</source>
        <translation>Geben Sie on oder off ein.</translation>
    </message>
    <message>
        <source>Type three numbers: x, y, z.</source>
        <translation>Geben Sie drei Zahlen ein: x, y, z.</translation>
    </message>
    <message>
        <source>Type: 1/3, 2*pi, 30deg</source>
        <translation>Tippen: 1/3, 2*pi, 30deg</translation>
    </message>
    <message>
        <source>unchanged since it last ran</source>
        <translation>unverändert, seit er zuletzt lief</translation>
    </message>
    <message>
        <source>Uncompressed.</source>
        <translation>Unkomprimiert.</translation>
    </message>
    <message>
        <source>under a high sun</source>
        <translation>unter hoher Sonne</translation>
    </message>
    <message>
        <source>Unevenness of the draft: 0 leans on the fur steadily and moves nothing, 1 blows in gusts.</source>
        <extracomment>tables</extracomment>
        <translation>Ungleichmäßigkeit des Luftzugs: 0 drückt stetig auf das Fell und bewegt nichts, 1 weht in Böen.</translation>
    </message>
    <message>
        <source>Unevenness of the dust: 0 is even air, high gathers it in drifts.</source>
        <extracomment>tables</extracomment>
        <translation>Ungleichmäßigkeit des Staubs: 0 ist gleichmäßige Luft, hohe Werte sammeln ihn in Schwaden.</translation>
    </message>
    <message>
        <source>Unevenness of the paper: 0 is smooth, 1 shows fibers.</source>
        <extracomment>tables</extracomment>
        <translation>Ungleichmäßigkeit des Papiers: 0 ist glatt, 1 zeigt Fasern.</translation>
    </message>
    <message>
        <source>Uniformity</source>
        <extracomment>tables</extracomment>
        <translation>Gleichmäßigkeit</translation>
    </message>
    <message>
        <source>Union: everything that is in any child.</source>
        <translation>Vereinigung: alles, was in einem der Kinder liegt.</translation>
    </message>
    <message>
        <source>Unions</source>
        <translation>Vereinigungen</translation>
    </message>
    <message>
        <source>unknown choice &quot;{1}&quot;; choose one of {2}.</source>
        <translation>Unbekannte Auswahl „{=1}“; wählen Sie eine von {=2}.</translation>
    </message>
    <message>
        <source>unknown ease &quot;{1}&quot;; give one of {2}</source>
        <translation>unbekannter Verlauf &quot;{=1}&quot;; geben Sie einen an von {=2}</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>unbekannter Fehler</translation>
    </message>
    <message>
        <source>unknown kind of motion &quot;{1}&quot;; give one of {2}</source>
        <translation>unbekannte Art von Bewegung &quot;{=1}&quot;; geben Sie eine an von {=2}</translation>
    </message>
    <message>
        <source>unknown {1} &quot;{2}&quot;; choose one of {3}.</source>
        <translation>unbekannt ({1}): &quot;{=2}&quot;; wählen Sie eines von {=3}.</translation>
    </message>
    <message>
        <source>unknown {1}: {2}</source>
        <translation>unbekannt ({1}): {=2}</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Unlock the group</source>
        <translation>Die Gruppe entsperren</translation>
    </message>
    <message>
        <source>Unwrap</source>
        <translation>Auspacken</translation>
    </message>
    <message>
        <source>Unwrap %1</source>
        <translation>%1 auspacken</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>up into the vault</source>
        <translation>hinauf ins Gewölbe</translation>
    </message>
    <message>
        <source>Up, Down, wheel</source>
        <translation>Auf, Ab, Mausrad</translation>
    </message>
    <message>
        <source>Upper blend</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Übergang</translation>
    </message>
    <message>
        <source>Upper color</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Farbe</translation>
    </message>
    <message>
        <source>Upper corner</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Rundung</translation>
    </message>
    <message>
        <source>upper cream</source>
        <extracomment>tables</extracomment>
        <translation>oberes Eis</translation>
    </message>
    <message>
        <source>Upper height</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Höhe</translation>
    </message>
    <message>
        <source>upper layer</source>
        <extracomment>tables</extracomment>
        <translation>obere Schicht</translation>
    </message>
    <message>
        <source>Upper layer of cream</source>
        <extracomment>tables</extracomment>
        <translation>Obere Eisschicht</translation>
    </message>
    <message>
        <source>Upper left corner</source>
        <translation>Ecke oben links</translation>
    </message>
    <message>
        <source>Upper lobes</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Wülste</translation>
    </message>
    <message>
        <source>Upper offset x</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Versatz x</translation>
    </message>
    <message>
        <source>Upper offset z</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Versatz z</translation>
    </message>
    <message>
        <source>Upper radius</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Radius</translation>
    </message>
    <message>
        <source>Upper raise</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Anheben</translation>
    </message>
    <message>
        <source>Upper right corner</source>
        <translation>Ecke oben rechts</translation>
    </message>
    <message>
        <source>Upper tilt</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Neigung</translation>
    </message>
    <message>
        <source>Upper twist</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Verdrillung</translation>
    </message>
    <message>
        <source>Upper yaw</source>
        <extracomment>tables</extracomment>
        <translation>Obere Schicht: Gieren</translation>
    </message>
    <message>
        <source>Upscale</source>
        <extracomment>tables</extracomment>
        <translation>Hochskalieren</translation>
    </message>
    <message>
        <source>Upward tilt of the view: negative looks down.</source>
        <extracomment>tables</extracomment>
        <translation>Neigung des Blicks nach oben: Negative Werte blicken nach unten.</translation>
    </message>
    <message>
        <source>Uses the selected variation, and draws nine new ones around it.</source>
        <translation>Übernimmt die gewählte Variation und zeichnet neun neue um sie herum.</translation>
    </message>
    <message>
        <source>Usual sizes</source>
        <translation>Übliche Größen</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>tables</extracomment>
        <translation>Value</translation>
    </message>
    <message>
        <source>Value of one of the scene's parameters, name=value. Numbers are in SI units.</source>
        <translation>Wert eines Parameters der Szene, name=wert. Zahlen stehen in SI-Einheiten.</translation>
    </message>
    <message>
        <source>Values of the pixel</source>
        <translation>Werte des Pixels</translation>
    </message>
    <message>
        <source>Variation %1 is shown.</source>
        <translation>Variation %1 wird gezeigt.</translation>
    </message>
    <message>
        <source>Variation %1 of %2 is being drawn.</source>
        <translation>Variation %1 von %2 wird gezeichnet.</translation>
    </message>
    <message>
        <source>Variation %1, seed %2</source>
        <translation>Variation %1, Startwert %2</translation>
    </message>
    <message>
        <source>Variation %1, seed %2, not drawn yet</source>
        <translation>Variation %1, Startwert %2, noch nicht gezeichnet</translation>
    </message>
    <message>
        <source>Variation %1, seed %2, shown</source>
        <translation>Variation %1, Startwert %2, wird gezeigt</translation>
    </message>
    <message>
        <source>Variation of color between strands: at 0 all have the same color.</source>
        <extracomment>tables</extracomment>
        <translation>Unterschiede in der Farbe der Haare: Bei 0 haben alle dieselbe.</translation>
    </message>
    <message>
        <source>Variation of color between the papers: at 0 all are alike, at 1 they are as varied as at a festival.</source>
        <extracomment>tables</extracomment>
        <translation>Unterschiede in der Farbe der Papiere: Bei 0 sind alle gleich, bei 1 bunt wie auf einem Fest.</translation>
    </message>
    <message>
        <source>Variation of thickness between strands: at 0 all have the coat's thickness, at 1 they range from that down to none.</source>
        <extracomment>tables</extracomment>
        <translation>Unterschiede in der Dicke der Haare: Bei 0 haben alle die Dicke des Fells, bei 1 jede von da bis nichts.</translation>
    </message>
    <message>
        <source>Version, libraries, license.</source>
        <translation>Version, Bibliotheken, Lizenz.</translation>
    </message>
    <message>
        <source>vertical</source>
        <extracomment>tables</extracomment>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>Vertical field of view, from the lower to the upper edge of the picture.</source>
        <translation>Vertikales Sichtfeld, vom unteren bis zum oberen Bildrand.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>view %1: %2 %</source>
        <translation>Ansicht %1: %2 %</translation>
    </message>
    <message>
        <source>View to turn and shift</source>
        <translation>Ansicht zum Drehen und Verschieben</translation>
    </message>
    <message>
        <source>View to turn and shift, where its picture does not lie over the others.</source>
        <translation>Ansicht zum Drehen und Verschieben, wenn ihr Bild nicht auf den anderen liegt.</translation>
    </message>
    <message>
        <source>View width</source>
        <translation>Ansichtsbreite</translation>
    </message>
    <message>
        <source>Viewing distance for which the pitch of the strips is made: at it, the whole card shows one view. Large values make it parallel.</source>
        <extracomment>tables</extracomment>
        <translation>Betrachtungsabstand, für den der Abstand der Streifen gemacht ist: Dort zeigt die ganze Karte eine Ansicht. Große Werte sind parallel.</translation>
    </message>
    <message>
        <source>Viewing distance, from which the pitch of the strips follows. Inf: none in particular, strips lie exactly at the pitch of the lenses.</source>
        <translation>Betrachtungsabstand, aus dem der Abstand der Streifen folgt. Inf: kein bestimmter, die Streifen liegen genau im Abstand der Linsen.</translation>
    </message>
    <message>
        <source>Viewing zone</source>
        <translation>Betrachtungszone</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Views rendered from the picture in the window, read from a folder or a list of pictures,
or cut from one picture with a grid of views. A folder or pictures can also be dropped here.</source>
        <translation>Ansichten, die aus dem Bild des Fensters gerendert, aus einem Ordner oder einer Liste von Bildern gelesen
oder aus einem Bild mit einem Raster von Ansichten geschnitten werden. Ein Ordner oder Bilder lassen sich auch hier ablegen.</translation>
    </message>
    <message>
        <source>Views side by side in a quilt.</source>
        <translation>Ansichten nebeneinander in einem Quilt.</translation>
    </message>
    <message>
        <source>Views that show</source>
        <translation>Sichtbare Ansichten</translation>
    </message>
    <message>
        <source>Views, interlaced.</source>
        <translation>Verschachtelte Ansichten.</translation>
    </message>
    <message>
        <source>Visit %1</source>
        <translation>%1 besuchen</translation>
    </message>
    <message>
        <source>Visit an exhibit first: the hall has nothing around it that could be left out.</source>
        <translation>Besuchen Sie zuerst ein Exponat: Um die Halle herum ist nichts, was wegbleiben könnte.</translation>
    </message>
    <message>
        <source>Visit an exhibit first; each lesson is about one exhibit.</source>
        <translation>Besuchen Sie zuerst ein Exponat; jede Lektion handelt von einem.</translation>
    </message>
    <message>
        <source>Visit an exhibit, press a button</source>
        <translation>Ein Exponat besuchen, einen Knopf drücken</translation>
    </message>
    <message>
        <source>Visit the previous or the next exhibit</source>
        <translation>Das vorige oder das nächste Exponat besuchen</translation>
    </message>
    <message>
        <source>Visit what is in the middle of the picture, or press its button</source>
        <translation>Besuchen, was in der Mitte des Bildes ist, oder dessen Knopf drücken</translation>
    </message>
    <message>
        <source>Visitor's object</source>
        <extracomment>tables</extracomment>
        <translation>Objekt des Besuchers</translation>
    </message>
    <message>
        <source>Visual per inch</source>
        <translation>Visuell pro Zoll</translation>
    </message>
    <message>
        <source>Vitrine %1
A workbench for real-time rendering techniques, in a museum.

Made with Qt %2, QCustomPlot, OpenGL 4.5 through libepoxy, GLM, Bullet,
OpenImageIO, tinygltf, nlohmann JSON, libpng and CLI11.
&quot;vitrine doctor&quot; tells their versions and what this machine can do.

Free software under the GNU General Public License, version 3 or later;
it comes without any warranty. Where models, textures and fonts come from
is written in assets/SOURCES.md.</source>
        <translation>Vitrine %1
Eine Werkbank für Echtzeit-Rendering, in einem Museum.

Gemacht mit Qt %2, QCustomPlot, OpenGL 4.5 über libepoxy, GLM, Bullet,
OpenImageIO, tinygltf, nlohmann JSON, libpng und CLI11.
„vitrine doctor“ nennt ihre Versionen, und was dieser Rechner kann.

Freie Software unter der GNU General Public License, Version 3 oder neuer;
ohne jede Gewährleistung. Woher Modelle, Texturen und Schriften stammen,
steht in assets/SOURCES.md.</translation>
    </message>
    <message>
        <source>Vitrine crashed or was stopped; your last state was restored.</source>
        <translation>Vitrine ist abgestürzt oder wurde beendet; Ihr letzter Stand wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>volume</source>
        <extracomment>tables</extracomment>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume steps</source>
        <extracomment>tables</extracomment>
        <translation>Volumenschritte</translation>
    </message>
    <message>
        <source>vote</source>
        <extracomment>tables</extracomment>
        <translation>Abstimmung</translation>
    </message>
    <message>
        <source>W A S D to walk, click an exhibit to tune it</source>
        <translation>W A S D zum Gehen; klicken Sie ein Exponat an, um es einzustellen</translation>
    </message>
    <message>
        <source>W A S D, arrows</source>
        <translation>W A S D, Pfeiltasten</translation>
    </message>
    <message>
        <source>Wafer</source>
        <extracomment>tables</extracomment>
        <translation>Waffel</translation>
    </message>
    <message>
        <source>Wafer blend</source>
        <extracomment>tables</extracomment>
        <translation>Waffelübergang</translation>
    </message>
    <message>
        <source>Wafer color</source>
        <extracomment>tables</extracomment>
        <translation>Waffelfarbe</translation>
    </message>
    <message>
        <source>Wafer roughness</source>
        <extracomment>tables</extracomment>
        <translation>Waffelrauheit</translation>
    </message>
    <message>
        <source>waiting for the disk</source>
        <translation>das Warten auf den Datenträger</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Walk until the sun leaves the picture: these beams fade, because what is not seen cannot shine.</source>
        <translation>Gehen Sie, bis die Sonne das Bild verlässt: Diese Strahlen verblassen, denn was nicht zu sehen ist, kann nicht scheinen.</translation>
    </message>
    <message>
        <source>Walk; Shift runs</source>
        <translation>Gehen; Umschalt läuft</translation>
    </message>
    <message>
        <source>Walk; the right trigger, or pressing the stick, runs</source>
        <translation>Gehen; der rechte Trigger, oder ein Druck auf den Stick, läuft</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <extracomment>tables</extracomment>
        <translation>Wandstärke</translation>
    </message>
    <message>
        <source>wall time around glFinish</source>
        <translation>Zeit der Wanduhr um glFinish</translation>
    </message>
    <message>
        <source>Warmth of the dusk at the horizon: 0 is cool, 1 glows like a sunset.</source>
        <extracomment>tables</extracomment>
        <translation>Wärme der Dämmerung am Horizont: 0 ist kühl, 1 glüht wie ein Sonnenuntergang.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Warp</source>
        <extracomment>tables</extracomment>
        <translation>Verzerrung</translation>
    </message>
    <message>
        <source>Water</source>
        <extracomment>tables</extracomment>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>Water color</source>
        <extracomment>tables</extracomment>
        <translation>Wasserfarbe</translation>
    </message>
    <message>
        <source>Water steps</source>
        <extracomment>tables</extracomment>
        <translation>Wasserschritte</translation>
    </message>
    <message>
        <source>Wave height</source>
        <extracomment>tables</extracomment>
        <translation>Wellenhöhe</translation>
    </message>
    <message>
        <source>Wave speed</source>
        <extracomment>tables</extracomment>
        <translation>Wellengeschwindigkeit</translation>
    </message>
    <message>
        <source>Waves</source>
        <extracomment>tables</extracomment>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>waves per cell</source>
        <translation>Wellen pro Zelle</translation>
    </message>
    <message>
        <source>Wax</source>
        <translation>Wachs</translation>
    </message>
    <message>
        <source>Way that a printed dot chooses among the views under it: the one at its middle, all by area, or by area with blended strip edges.</source>
        <translation>Art, wie ein gedruckter Punkt unter den Ansichten darunter wählt: die in seiner Mitte, alle nach Fläche oder nach Fläche mit überblendeten Streifenrändern.</translation>
    </message>
    <message>
        <source>Way that the animation carries the object from its first to its last moment: kept, so that the frames hold all of it, or taken out of the frames, so that it walks in place and the pivot moves. Automatic takes out what is longer than the object.</source>
        <translation>Weg, den die Animation das Objekt von ihrem ersten bis zu ihrem letzten Moment trägt: beibehalten, sodass die Frames ihn ganz enthalten, oder aus den Frames genommen, sodass es auf der Stelle läuft und der Drehpunkt wandert. Automatisch nimmt heraus, was länger als das Objekt ist.</translation>
    </message>
    <message>
        <source>Way to set the sun: by its angles and color, or by the time of day, with which it moves, reddens and sets.</source>
        <extracomment>tables</extracomment>
        <translation>Wie die Sonne gesetzt wird: nach ihren Winkeln und ihrer Farbe oder nach der Tageszeit, mit der sie wandert, sich rötet und untergeht.</translation>
    </message>
    <message>
        <source>weather</source>
        <translation>Wetter</translation>
    </message>
    <message>
        <source>Weight</source>
        <extracomment>tables</extracomment>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>What a ray costs</source>
        <translation>Was ein Strahl kostet</translation>
    </message>
    <message>
        <source>what a server left there cannot be removed ({1}); choose another path.</source>
        <translation>Was ein Server dort hinterließ, lässt sich nicht entfernen ({1}); wählen Sie einen anderen Pfad.</translation>
    </message>
    <message>
        <source>What becomes of pictures that are not shaped as the print is: cropped at two sides, seen whole between white margins, or distorted.</source>
        <translation>Was aus Bildern wird, die nicht das Format des Drucks haben: an zwei Seiten beschnitten, ganz zwischen weißen Rändern zu sehen oder verzerrt.</translation>
    </message>
    <message>
        <source>What costs are counted in</source>
        <translation>Worin Kosten gezählt werden</translation>
    </message>
    <message>
        <source>What counts as exact is not checked: {1}</source>
        <translation>Was als exakt gilt, ist nicht geprüft: {1}</translation>
    </message>
    <message>
        <source>What does accuracy cost?</source>
        <translation>Was kostet Genauigkeit?</translation>
    </message>
    <message>
        <source>What each ray costs</source>
        <translation>Was jeder Strahl kostet</translation>
    </message>
    <message>
        <source>What halving the error costs cannot be told from so few points that vary so much: measure more values.</source>
        <translation>Was es kostet, den Fehler zu halbieren, lässt sich aus so wenigen Punkten, die so stark schwanken, nicht sagen: Messen Sie mehr Werte.</translation>
    </message>
    <message>
        <source>what hangs here has turned</source>
        <translation>was hier hängt, hat sich gedreht</translation>
    </message>
    <message>
        <source>What is brought from elsewhere has no kind of its own; change it where it is written.</source>
        <translation>Was von anderswo kommt, hat keine eigene Art; ändern Sie es dort, wo es geschrieben steht.</translation>
    </message>
    <message>
        <source>What is drawn and why</source>
        <translation>Was gezeichnet wird, und warum</translation>
    </message>
    <message>
        <source>what is near</source>
        <extracomment>tables</extracomment>
        <translation>was nah ist</translation>
    </message>
    <message>
        <source>what is near is still being found</source>
        <translation>was nah ist, wird noch gesucht</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>Was gezeigt wird</translation>
    </message>
    <message>
        <source>what is shown</source>
        <translation>das Gezeigte</translation>
    </message>
    <message>
        <source>What lies behind a shell is covered in either order, so that the picture is the same.</source>
        <translation>Was hinter einer Shell liegt, wird in jeder Reihenfolge verdeckt, so dass das Bild dasselbe ist.</translation>
    </message>
    <message>
        <source>What surrounds the scene is black until it can be read.</source>
        <translation>Was die Szene umgibt, ist schwarz, bis es gelesen werden kann.</translation>
    </message>
    <message>
        <source>What the frame cost</source>
        <translation>Was der Frame gekostet hat</translation>
    </message>
    <message>
        <source>what the probe sees has changed</source>
        <translation>was die Sonde sieht, hat sich geändert</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>What to measure</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>What to print</source>
        <translation>Was gedruckt wird</translation>
    </message>
    <message>
        <source>What to see</source>
        <translation>Was zu sehen ist</translation>
    </message>
    <message>
        <source>Wheel, + and −</source>
        <translation>Mausrad, + und −</translation>
    </message>
    <message>
        <source>When the lamps in the vault are lit: automatically while the sun is lower than eight degrees, always, or never.</source>
        <extracomment>tables</extracomment>
        <translation>Wann die Lampen im Gewölbe brennen: automatisch, solange die Sonne tiefer als acht Grad steht, immer oder nie.</translation>
    </message>
    <message>
        <source>Where B comes from</source>
        <translation>Woher B kommt</translation>
    </message>
    <message>
        <source>Where the views come from</source>
        <translation>Woher die Ansichten kommen</translation>
    </message>
    <message>
        <source>Where the views come from: rendered from the picture in the window, read from pictures, or cut from a grid of views.</source>
        <translation>Woher die Ansichten kommen: aus dem Bild des Fensters gerendert, aus Bildern gelesen, oder aus einem Raster von Ansichten geschnitten.</translation>
    </message>
    <message>
        <source>whether a server answers there cannot be told ({1}); choose another path.</source>
        <translation>Ob dort ein Server antwortet, ist nicht zu erkennen ({1}); wählen Sie einen anderen Pfad.</translation>
    </message>
    <message>
        <source>Whether baked sky light and occlusion light the walls; without it, they get one even ambient light.</source>
        <extracomment>tables</extracomment>
        <translation>Ob gebackenes Himmelslicht und Verdeckung die Wände beleuchten; ohne das bekommen sie ein gleichmäßiges Umgebungslicht.</translation>
    </message>
    <message>
        <source>Whether fewer shells are drawn where the coat is far away and small.</source>
        <extracomment>tables</extracomment>
        <translation>Ob weniger Shells gezeichnet werden, wo das Fell weit weg und klein ist.</translation>
    </message>
    <message>
        <source>Whether frames in motion are averaged with motion compensation (TAA); without it, edges crawl and fine details flicker until the picture is idle.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Frames in Bewegung mit Bewegungsausgleich gemittelt werden (TAA); ohne das kriechen Kanten, und Feines flimmert, bis das Bild ruht.</translation>
    </message>
    <message>
        <source>Whether lines separate objects that touch.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Linien Objekte trennen, die sich berühren.</translation>
    </message>
    <message>
        <source>Whether objects cast shadows.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Objekte Schatten werfen.</translation>
    </message>
    <message>
        <source>Whether one cone per 8 × 8 pixels is marched first; their rays start at the end of the cone.</source>
        <extracomment>tables</extracomment>
        <translation>Ob zuerst ein Kegel je 8 × 8 Pixel abgeschritten wird; deren Strahlen beginnen an seinem Ende.</translation>
    </message>
    <message>
        <source>Whether radius and thickness follow from LPI, zone and index, focused on the back, or are as given below.</source>
        <translation>Ob Radius und Dicke aus LPI, Zone und Index folgen, auf die Rückseite fokussiert, oder wie unten angegeben sind.</translation>
    </message>
    <message>
        <source>Whether red, green and blue are refracted separately, by Cauchy's formula.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Rot, Grün und Blau getrennt gebrochen werden, nach Cauchys Formel.</translation>
    </message>
    <message>
        <source>Whether samples and steps are shifted by blue noise: too few of them then look like grain, not like bands.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Samples und Schritte durch blaues Rauschen versetzt werden: Zu wenige davon wirken dann wie Korn und nicht wie Streifen.</translation>
    </message>
    <message>
        <source>Whether sand and a black horizon surround the ice cream when it is shown alone.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Sand und ein schwarzer Horizont das Eis umgeben, wenn es allein gezeigt wird.</translation>
    </message>
    <message>
        <source>Whether the ball grows and shrinks all the time; otherwise only during a jump.</source>
        <extracomment>tables</extracomment>
        <translation>Ob der Ball ständig wächst und schrumpft; sonst nur während eines Sprungs.</translation>
    </message>
    <message>
        <source>Whether the camera moves by whole texels and turns by whole steps, so that pixels do not crawl; the remainder shifts the finished picture.</source>
        <extracomment>tables</extracomment>
        <translation>Ob sich die Kamera um ganze Texel bewegt und um ganze Schritte dreht, sodass Pixel nicht kriechen; der Rest verschiebt das fertige Bild.</translation>
    </message>
    <message>
        <source>Whether the candies spin, those in the air float, and the whole turns.</source>
        <extracomment>tables</extracomment>
        <translation>Ob sich die Bonbons drehen, die in der Luft schweben und das Ganze sich dreht.</translation>
    </message>
    <message>
        <source>Whether the candles burn.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Kerzen brennen.</translation>
    </message>
    <message>
        <source>Whether the card scrolls from one print to the other and back, like a billboard.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Karte von einem Druck zum anderen und zurück rollt, wie eine Werbetafel.</translation>
    </message>
    <message>
        <source>Whether the draft turns the mobile and carries the dust.</source>
        <extracomment>tables</extracomment>
        <translation>Ob der Luftzug das Mobile dreht und den Staub trägt.</translation>
    </message>
    <message>
        <source>Whether the edges of the bounding mesh are drawn: amber if it holds the object, red if it clips it.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Kanten des Hüllnetzes gezeichnet werden: bernsteinfarben, wenn es das Objekt umschließt, rot, wenn es beschneidet.</translation>
    </message>
    <message>
        <source>Whether the empty background gets normals towards the camera, so that objects have no edges against it.</source>
        <extracomment>tables</extracomment>
        <translation>Ob der leere Hintergrund Normalen zur Kamera bekommt, sodass Objekte gegen ihn keine Kanten haben.</translation>
    </message>
    <message>
        <source>Whether the first view lies on the left under each lens: turns depth inside out, or a reversed sequence right.</source>
        <translation>Ob die erste Ansicht links unter jeder Linse liegt: kehrt die Tiefe um oder eine umgekehrte Folge richtig herum.</translation>
    </message>
    <message>
        <source>Whether the floor is darkened around the things that stand on it; without it, feet and plinths seem to float.</source>
        <extracomment>tables</extracomment>
        <translation>Ob der Boden rings um alles, was darauf steht, dunkler wird; ohne das scheinen Füße und Sockel zu schweben.</translation>
    </message>
    <message>
        <source>Whether the hall is captured once as a reflection probe for everything in it; without it, nothing reflects.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Halle einmal als Reflexionssonde für alles in ihr aufgenommen wird; ohne das spiegelt nichts.</translation>
    </message>
    <message>
        <source>Whether the hall's light is darkened where the object hides it, at five evaluations per pixel.</source>
        <extracomment>tables</extracomment>
        <translation>Ob das Licht der Halle abgedunkelt wird, wo das Objekt es verdeckt, mit fünf Auswertungen pro Pixel.</translation>
    </message>
    <message>
        <source>Whether the ice cream is built up stage by stage, again and again.</source>
        <extracomment>tables</extracomment>
        <translation>Ob das Eis Stufe für Stufe aufgebaut wird, wieder und wieder.</translation>
    </message>
    <message>
        <source>Whether the ice cream stands on a plinth.</source>
        <extracomment>tables</extracomment>
        <translation>Ob das Eis auf einem Sockel steht.</translation>
    </message>
    <message>
        <source>Whether the lens and the pixel are integrated over; without it, one ray per pixel gives moiré from afar.</source>
        <extracomment>tables</extracomment>
        <translation>Ob über Linse und Pixel integriert wird; ohne das gibt ein Strahl pro Pixel aus der Ferne Moiré.</translation>
    </message>
    <message>
        <source>Whether the mask carries the colors of the sky; otherwise it is plain white.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Maske die Farben des Himmels trägt; sonst ist sie reinweiß.</translation>
    </message>
    <message>
        <source>Whether the model turns about the vertical axis, once per round of 4 s.</source>
        <extracomment>tables</extracomment>
        <translation>Ob sich das Modell um die senkrechte Achse dreht, einmal je Runde von 4 s.</translation>
    </message>
    <message>
        <source>Whether the next four parameters set how the fur lies, while the bodies stand still.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die nächsten vier Parameter bestimmen, wie das Fell liegt, während die Körper stillstehen.</translation>
    </message>
    <message>
        <source>Whether the picture is split into two halves, each with its own method and view.</source>
        <extracomment>tables</extracomment>
        <translation>Ob das Bild in zwei Hälften geteilt wird, jede mit eigenem Verfahren und eigener Ansicht.</translation>
    </message>
    <message>
        <source>Whether the picture is split into two halves; the right one has its own parameters.</source>
        <extracomment>tables</extracomment>
        <translation>Ob das Bild in zwei Hälften geteilt wird; die rechte hat eigene Parameter.</translation>
    </message>
    <message>
        <source>Whether the print is mirrored, for printing on the back of the sheet.</source>
        <translation>Ob der Druck gespiegelt wird, für den Druck auf die Rückseite der Folie.</translation>
    </message>
    <message>
        <source>Whether the shape melts back and forth, starting from the morph above.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Form hin und her schmilzt, vom Morph darüber an.</translation>
    </message>
    <message>
        <source>Whether the steps are shifted by blue noise, differently in each sample: too few of them then look like grain, not like shells.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Schritte durch blaues Rauschen versetzt werden, in jedem Sample anders: Zu wenige davon wirken dann wie Korn und nicht wie Schalen.</translation>
    </message>
    <message>
        <source>Whether the views are printed in reverse order: depth turns inside out.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Ansichten in umgekehrter Reihenfolge gedruckt sind: Die Tiefe kehrt sich um.</translation>
    </message>
    <message>
        <source>Whether time runs: the field drifts, waves roll, clouds sail.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Zeit läuft: Das Feld treibt, Wellen rollen, Wolken segeln.</translation>
    </message>
    <message>
        <source>Whether time runs: the torus tumbles, cubes bob, water moves; a round takes 4 s.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Zeit läuft: Der Torus taumelt, Würfel wippen, Wasser bewegt sich; eine Runde dauert 4 s.</translation>
    </message>
    <message>
        <source>Whether time runs: waves roll, flames flicker, lanterns drift.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Zeit läuft: Wellen rollen, Flammen flackern, Laternen treiben.</translation>
    </message>
    <message>
        <source>Whether time runs; it shows only in scenes in which something moves.</source>
        <extracomment>tables</extracomment>
        <translation>Ob die Zeit läuft; zu sehen nur in Szenen, in denen sich etwas bewegt.</translation>
    </message>
    <message>
        <source>Whether to mirror at the plane x = 0.</source>
        <translation>Ob an der Ebene x = 0 gespiegelt wird.</translation>
    </message>
    <message>
        <source>Whether to mirror at the plane y = 0.</source>
        <translation>Ob an der Ebene y = 0 gespiegelt wird.</translation>
    </message>
    <message>
        <source>Whether to mirror at the plane z = 0.</source>
        <translation>Ob an der Ebene z = 0 gespiegelt wird.</translation>
    </message>
    <message>
        <source>Whether to shade by Phong's formulas without tone mapping, as in the reference.</source>
        <translation>Ob nach Phongs Formeln ohne Tone Mapping beleuchtet wird, wie in der Referenz.</translation>
    </message>
    <message>
        <source>Whether walls and exhibits block the sun; without it, the sun shines through everything.</source>
        <extracomment>tables</extracomment>
        <translation>Ob Wände und Exponate die Sonne abhalten; ohne das scheint sie durch alles hindurch.</translation>
    </message>
    <message>
        <source>Which one?</source>
        <translation>Welche soll gelten?</translation>
    </message>
    <message>
        <source>while the new program is being built</source>
        <translation>während das neue Programm gebaut wird</translation>
    </message>
    <message>
        <source>While two settings are compared</source>
        <translation>Während zwei Einstellungen verglichen werden</translation>
    </message>
    <message>
        <source>White paper around trim and bleed, on every side.</source>
        <translation>Weißes Papier um Beschnitt und Anschnitt, auf jeder Seite.</translation>
    </message>
    <message>
        <source>whole numbers only)</source>
        <translation>nur ganze Zahlen)</translation>
    </message>
    <message>
        <source>Whole pictures of A and B, side by side.</source>
        <translation>Die ganzen Bilder von A und B nebeneinander.</translation>
    </message>
    <message>
        <source>Whose parameters</source>
        <translation>Wessen Parameter</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Why does it have no effect?</source>
        <translation>Warum hat das keine Wirkung?</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width below which a lantern is drawn as a glowing point.</source>
        <extracomment>tables</extracomment>
        <translation>Breite, unter der eine Laterne als leuchtender Punkt gezeichnet wird.</translation>
    </message>
    <message>
        <source>Width below which lanterns are drawn as their average.</source>
        <extracomment>tables</extracomment>
        <translation>Breite, unter der Laternen als ihr Mittel gezeichnet werden.</translation>
    </message>
    <message>
        <source>Width of a cell; never less than a lantern needs.</source>
        <extracomment>tables</extracomment>
        <translation>Breite einer Zelle; nie weniger, als eine Laterne braucht.</translation>
    </message>
    <message>
        <source>Width of the blend between posts and rings; 0 joins them sharply.</source>
        <extracomment>tables</extracomment>
        <translation>Breite des Übergangs zwischen Pfosten und Ringen; 0 verbindet sie scharf.</translation>
    </message>
    <message>
        <source>Width of the blend; 0 leaves a sharp edge.</source>
        <translation>Breite der Verschmelzung; 0 lässt eine scharfe Kante.</translation>
    </message>
    <message>
        <source>Width of the files into which the print is cut, between lenses. Auto: one file.</source>
        <translation>Breite der Dateien, in die der Druck zwischen den Linsen geschnitten wird. Auto: eine Datei.</translation>
    </message>
    <message>
        <source>Width of the fillet between cream and wafer: wide looks melted.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rundung zwischen Eis und Waffel: Breite wirkt geschmolzen.</translation>
    </message>
    <message>
        <source>Width of the fillet between neighboring cones: wide makes soft folds.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rundung zwischen benachbarten Kegeln: Breite gibt weiche Falten.</translation>
    </message>
    <message>
        <source>Width of the fillet between the relief (bars and rings) and the foot; 0 joins them sharply.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rundung zwischen dem Relief (Stäbe und Ringe) und dem Fuß; 0 verbindet sie scharf.</translation>
    </message>
    <message>
        <source>Width of the fillet between the two layers of cream; 0 joins them sharply.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rundung zwischen den beiden Eisschichten; 0 verbindet sie scharf.</translation>
    </message>
    <message>
        <source>Width of the fillet where bars cross rings; 0 joins them sharply.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rundung, wo Stäbe Ringe kreuzen; 0 verbindet sie scharf.</translation>
    </message>
    <message>
        <source>Width of the fillet where the handle meets the cup; 0 joins them hard.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rundung, wo der Henkel auf die Tasse trifft; 0 verbindet sie hart.</translation>
    </message>
    <message>
        <source>Width of the ribs.</source>
        <extracomment>tables</extracomment>
        <translation>Breite der Rippen.</translation>
    </message>
    <message>
        <source>Width of the white paper around the pictures.</source>
        <extracomment>tables</extracomment>
        <translation>Breite des weißen Papiers um die Bilder.</translation>
    </message>
    <message>
        <source>width x height in whole pixels</source>
        <translation>Breite x Höhe in ganzen Pixeln</translation>
    </message>
    <message>
        <source>Wind</source>
        <extracomment>tables</extracomment>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Wind direction</source>
        <extracomment>tables</extracomment>
        <translation>Windrichtung</translation>
    </message>
    <message>
        <source>Wind speed</source>
        <extracomment>tables</extracomment>
        <translation>Windgeschwindigkeit</translation>
    </message>
    <message>
        <source>Wind speed ten meters above the water, in meters per second: high makes longer and higher waves.</source>
        <extracomment>tables</extracomment>
        <translation>Windgeschwindigkeit zehn Meter über dem Wasser, in Metern pro Sekunde: Hohe Werte geben längere und höhere Wellen.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>window ahead</source>
        <translation>Fenster voraus</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Wischblende</translation>
    </message>
    <message>
        <source>Wipe between setting and reference</source>
        <translation>Wischblende zwischen Einstellung und Referenz</translation>
    </message>
    <message>
        <source>With --reverse the depth of rendered views is inside out.</source>
        <translation>Mit --reverse kehrt sich die Tiefe gerenderter Ansichten um.</translation>
    </message>
    <message>
        <source>With a gamepad</source>
        <translation>Mit einem Gamepad</translation>
    </message>
    <message>
        <source>with its border it has more than 2147483647 pixels on a side</source>
        <translation>mit seinem Rand hat er mehr als 2147483647 Pixel auf einer Seite</translation>
    </message>
    <message>
        <source>with its constant numbers compiled in</source>
        <translation>mit eingerechneten konstanten Zahlen</translation>
    </message>
    <message>
        <source>With one view the print shows the same picture from everywhere.</source>
        <translation>Mit einer Ansicht zeigt der Druck von überall dasselbe Bild.</translation>
    </message>
    <message>
        <source>With the best of the settings, halving the error</source>
        <translation>Mit den besten der Einstellungen den Fehler zu halbieren</translation>
    </message>
    <message>
        <source>With {1} pixels per lens the printer cannot separate views.</source>
        <translation>Mit {1} Pixeln pro Linse kann der Drucker Ansichten nicht trennen.</translation>
    </message>
    <message>
        <source>within a step there are the headings &quot;### Try&quot;, &quot;### Question&quot; and &quot;### Answer&quot;; write one of them, or &quot;## &quot; for a step.</source>
        <translation>in einem Schritt gibt es die Überschriften „### Try“, „### Question“ und „### Answer“; schreiben Sie eine davon, oder „## “ für einen Schritt.</translation>
    </message>
    <message>
        <source>woken by the button {1} ago</source>
        <translation>vom Knopf geweckt vor {1}</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Werk</translation>
    </message>
    <message>
        <source>work for several frames needs a key</source>
        <translation>Arbeit für mehrere Frames braucht einen Schlüssel</translation>
    </message>
    <message>
        <source>Work to show: blobs of one octave (field), of many octaves (fractal sum), a sea of waves, or a sky of clouds, all made of noise.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigtes Werk: Klumpen aus einer Oktave (Feld), aus vielen Oktaven (fraktale Summe), ein Meer aus Wellen oder ein Wolkenhimmel, alles aus Rauschen.</translation>
    </message>
    <message>
        <source>World</source>
        <extracomment>tables</extracomment>
        <translation>Welt</translation>
    </message>
    <message>
        <source>World to show: a small isle, the test scene of the reference, or bars of one and two pixels.</source>
        <extracomment>tables</extracomment>
        <translation>Gezeigte Welt: eine kleine Insel, die Testszene der Referenz oder Stäbe von ein und zwei Pixeln.</translation>
    </message>
    <message>
        <source>Wrap</source>
        <translation>Einpacken</translation>
    </message>
    <message>
        <source>Wrap %1 in %2</source>
        <translation>%1 in %2 einpacken</translation>
    </message>
    <message>
        <source>Wrap in</source>
        <translation>Einpacken in</translation>
    </message>
    <message>
        <source>Wraps the selected node in an operation.</source>
        <translation>Packt den gewählten Knoten in eine Operation.</translation>
    </message>
    <message>
        <source>write &quot;milliseconds&quot;, &quot;row:NAME&quot; or &quot;counter:NAME&quot; here.</source>
        <translation>schreiben Sie hier „milliseconds“, „row:NAME“ oder „counter:NAME“.</translation>
    </message>
    <message>
        <source>Write a second sheet with normals, view space, aligned to the pixel.</source>
        <translation>Schreibt einen zweiten Bogen mit Normalen im Blickraum, auf das Pixel deckungsgleich.</translation>
    </message>
    <message>
        <source>Write a third sheet with depth: near is white.</source>
        <translation>Schreibt einen dritten Bogen mit der Tiefe: nah ist weiß.</translation>
    </message>
    <message>
        <source>Write where every frame lies, in the JSON that Aseprite exports.</source>
        <translation>Schreibt, wo jedes Bild liegt, im JSON, das Aseprite ausgibt.</translation>
    </message>
    <message>
        <source>Writes the bookmarks to a file that `vitrine record` follows.</source>
        <translation>Schreibt die Lesezeichen in eine Datei, der `vitrine record` folgt.</translation>
    </message>
    <message>
        <source>Writes the selected preset to a file.</source>
        <translation>Schreibt das gewählte Preset in eine Datei.</translation>
    </message>
    <message>
        <source>Writes the tree to another file.</source>
        <translation>Schreibt den Baum in eine andere Datei.</translation>
    </message>
    <message>
        <source>writes videos</source>
        <translation>schreibt Videos</translation>
    </message>
    <message>
        <source>Writes your edits in the tree to the scene file.</source>
        <translation>Schreibt Ihre Änderungen im Baum in die Szenendatei.</translation>
    </message>
    <message>
        <source>Writes your edits to the scene file.</source>
        <translation>Schreibt Ihre Änderungen in die Szenendatei.</translation>
    </message>
    <message>
        <source>writing a frame</source>
        <translation>das Schreiben eines Frames</translation>
    </message>
    <message>
        <source>writing failed ({1})</source>
        <translation>das Schreiben ist misslungen ({=1})</translation>
    </message>
    <message>
        <source>writing the comment failed</source>
        <translation>das Schreiben des Kommentars ist misslungen</translation>
    </message>
    <message>
        <source>Writing {1} was stopped; nothing was changed.</source>
        <translation>Das Schreiben von {=1} wurde angehalten; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Yaw</source>
        <extracomment>tables</extracomment>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>You can also type “%1”.</source>
        <translation>„%1“ kann auch eingetippt werden.</translation>
    </message>
    <message>
        <source>You look at %1, from %2 m away.</source>
        <translation>Sie sehen %1 an, aus %2 m Entfernung.</translation>
    </message>
    <message>
        <source>You walk through the hall and look at %1.</source>
        <translation>Sie gehen durch die Halle und sehen %1 an.</translation>
    </message>
    <message>
        <source>You walk through the hall.</source>
        <translation>Sie gehen durch die Halle.</translation>
    </message>
    <message>
        <source>You walk through the hall. Before you: %1.</source>
        <translation>Sie gehen durch die Halle. Vor Ihnen: %1.</translation>
    </message>
    <message>
        <source>Your bookmarks are kept for this session only: %1</source>
        <translation>Ihre Lesezeichen bleiben nur für diese Sitzung erhalten: %1</translation>
    </message>
    <message>
        <source>Your last session could not be restored and was kept as %1.</source>
        <translation>Ihre letzte Sitzung konnte nicht wiederhergestellt werden und wurde als %1 aufbewahrt.</translation>
    </message>
    <message>
        <source>Your last session was restored.</source>
        <translation>Ihr letzter Stand wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>Your last state was restored %1 times, and each time Vitrine crashed or was stopped soon after. It is not restored again; File &gt; Open brings it back from %2.</source>
        <translation>Ihr letzter Stand wurde %1-mal wiederhergestellt, und jedes Mal ist Vitrine bald danach abgestürzt oder wurde beendet. Er wird nicht noch einmal wiederhergestellt; Datei &gt; Öffnen holt ihn aus %2 zurück.</translation>
    </message>
    <message>
        <source>Your object: {1}</source>
        <translation>Ihr Objekt: {1}</translation>
    </message>
    <message>
        <source>Your own object</source>
        <translation>Ihr eigenes Objekt</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Yours, saved on %1.</source>
        <translation>Eigenes, gespeichert am %1.</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Zenith</source>
        <extracomment>tables</extracomment>
        <translation>Zenit</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Zoom in (+)</source>
        <translation>Vergrößern (+)</translation>
    </message>
    <message>
        <source>Zoom out (-)</source>
        <translation>Verkleinern (-)</translation>
    </message>
    <message>
        <source>ZX Spectrum</source>
        <extracomment>tables</extracomment>
        <translation>ZX Spectrum</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot; is no metric{3} give one of {4}</source>
        <translation>{=1} &quot;{=2}&quot; ist keine Metrik{3} geben Sie eine an von {=4}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: did you mean {3}? give one of {4}</source>
        <translation>{=1} &quot;{=2}&quot;: Meinten Sie {=3}? Geben Sie eines an von {=4}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: give name=value, such as {3}</source>
        <translation>{=1} &quot;{=2}&quot;: Geben Sie Name=Wert an, etwa {=3}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: give one of {3}</source>
        <translation>{=1} &quot;{=2}&quot;: Geben Sie eines an von {=3}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: give three numbers, such as {3} 1.5,2,-0.5.</source>
        <translation>{=1} „{=2}“: Geben Sie drei Zahlen an, etwa {=3} 1.5,2,-0.5.</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: give {3}</source>
        <translation>{=1} &quot;{=2}&quot;: Geben Sie an: {3}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: give {3}, each from 1 to 1000000, such as {4}</source>
        <translation>{=1} &quot;{=2}&quot;: Geben Sie {3} an, jede Zahl von 1 bis 1000000, etwa {=4}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: give {3}, such as {4}</source>
        <translation>{=1} „{=2}“: geben Sie {=3} an, etwa {=4}</translation>
    </message>
    <message>
        <source>{1} &quot;{2}&quot;: numbers have a decimal point here, in every language; write {3}</source>
        <translation>{=1} &quot;{=2}&quot;: Zahlen haben hier einen Dezimalpunkt, in jeder Sprache; schreiben Sie {=3}</translation>
    </message>
    <message>
        <source>{1} (better)</source>
        <translation>{1} (besser)</translation>
    </message>
    <message>
        <source>{1} (which acts when {2})</source>
        <translation>{1} (was wirkt, wenn {2})</translation>
    </message>
    <message>
        <source>{1} (while building {2}); correct the shader or reinstall the program.</source>
        <translation>{=1} (beim Bauen von {=2}); korrigieren Sie den Shader, oder installieren Sie das Programm neu.</translation>
    </message>
    <message>
        <source>{1} -&gt; {2} (allowed {3} to {4})</source>
        <translation>{=1} -&gt; {=2} (erlaubt {=3} bis {=4})</translation>
    </message>
    <message>
        <source>{1} -&gt; {2} (allowed {3} to {4}, whole numbers only)</source>
        <translation>{=1} -&gt; {=2} (erlaubt {=3} bis {=4}, nur ganze Zahlen)</translation>
    </message>
    <message>
        <source>{1} above {2}</source>
        <translation>{1} über {2}</translation>
    </message>
    <message>
        <source>{1} and others</source>
        <translation>{=1} und andere</translation>
    </message>
    <message>
        <source>{1} and {2}</source>
        <translation>{1} und {2}</translation>
    </message>
    <message>
        <source>{1} and {2} exclude each other; give one of them.</source>
        <translation>{=1} und {=2} schließen einander aus; geben Sie eines davon an.</translation>
    </message>
    <message>
        <source>{1} at {2}</source>
        <translation>{1} bei {2}</translation>
    </message>
    <message>
        <source>{1} at {2} limits {3}: see the error against everything exact.</source>
        <translation>{1} auf {2} begrenzt {3}: Es zählt der Fehler gegen das Bild, in dem alles genau ist.</translation>
    </message>
    <message>
        <source>{1} belongs to another version; </source>
        <translation>{=1} gehört zu einer anderen Version; </translation>
    </message>
    <message>
        <source>{1} belongs to {2}; give that, too.</source>
        <translation>{=1} gehört zu {=2}; geben Sie das ebenfalls an.</translation>
    </message>
    <message>
        <source>{1} between {2} and {3}, period {4} s</source>
        <translation>{1} zwischen {2} und {3}, Periode {4} s</translation>
    </message>
    <message>
        <source>{1} bytes; shorten it</source>
        <translation>{1} Bytes; kürzen Sie sie</translation>
    </message>
    <message>
        <source>{1} cells hold parts that are thinner than a cell; a smaller --cell keeps them.</source>
        <translation>{1} Zellen enthalten Teile, die dünner sind als eine Zelle; ein kleineres --cell erhält sie.</translation>
    </message>
    <message>
        <source>{1} costs {2} times the {3} ({4} to {5} with 95 % confidence).</source>
        <translation>{1}, kostet das {2}-Fache an {3} ({4} bis {5} mit 95 % Konfidenz).</translation>
    </message>
    <message>
        <source>{1} does not describe {2}: it is of another print, or was changed. The description inside the print was used; make the print anew, or remove {3}.</source>
        <translation>{=1} beschreibt {=2} nicht: Die Datei gehört zu einem anderen Druck oder wurde geändert. Die Beschreibung im Druck wurde verwendet; erzeugen Sie den Druck neu, oder entfernen Sie {=3}.</translation>
    </message>
    <message>
        <source>{1} does not hold the pictures of {2}; delete it.</source>
        <translation>{=1} enthält nicht die Bilder von {=2}; löschen Sie die Datei.</translation>
    </message>
    <message>
        <source>{1} failed ({2})</source>
        <translation>{1} ist misslungen ({=2})</translation>
    </message>
    <message>
        <source>{1} from {2} to {3}</source>
        <translation>{1} von {2} bis {3}</translation>
    </message>
    <message>
        <source>{1} from {2} to {3} at {4} to {5} m</source>
        <translation>{1} von {2} bis {3} bei {4} bis {5} m</translation>
    </message>
    <message>
        <source>{1} from {2} to {3} within {4} s</source>
        <translation>{1} von {2} bis {3} innerhalb von {4} s</translation>
    </message>
    <message>
        <source>{1} has no effect on {2}; leave it out.</source>
        <translation>{1} bewirkt nichts bei {2}; lassen Sie es weg.</translation>
    </message>
    <message>
        <source>{1} has no effect without {2}; leave it out, or give that too.</source>
        <translation>{1} bewirkt nichts ohne {2}; lassen Sie es weg oder geben Sie auch das an.</translation>
    </message>
    <message>
        <source>{1} has no parameter on which accuracy depends; name one of the hall, such as hall.supersamples.</source>
        <translation>{=1} hat keinen Parameter, von dem Genauigkeit abhängt; nennen Sie einen der Halle, etwa hall.supersamples.</translation>
    </message>
    <message>
        <source>{1} has no surface that could wear a coat. Give a model with triangles.</source>
        <translation>{=1} hat keine Oberfläche, die ein Fell tragen könnte. Geben Sie ein Modell mit Dreiecken an.</translation>
    </message>
    <message>
        <source>{1} has no triangle with an area that could wear a coat. Give a model with triangles.</source>
        <translation>{=1} hat kein Dreieck mit einer Fläche, die ein Fell tragen könnte. Geben Sie ein Modell mit Dreiecken an.</translation>
    </message>
    <message>
        <source>{1} has no values between two others; let a number, a color or a direction run.</source>
        <translation>{1} hat keine Werte zwischen zwei anderen; lassen Sie eine Zahl, eine Farbe oder eine Richtung laufen.</translation>
    </message>
    <message>
        <source>{1} has {2} × {3} pixels and is stretched over the sky: a picture of all directions is twice as wide as high.</source>
        <translation>{1} hat {2} × {3} Pixel und wird über den Himmel gestreckt: Ein Bild aller Richtungen ist doppelt so breit wie hoch.</translation>
    </message>
    <message>
        <source>{1} is a preset of &quot;{2}&quot;, which is not in this museum.</source>
        <translation>{=1} ist ein Preset von „{=2}“, das es in diesem Museum nicht gibt.</translation>
    </message>
    <message>
        <source>{1} is missing; make all parts anew.</source>
        <translation>{=1} fehlt; erzeugen Sie alle Teile neu.</translation>
    </message>
    <message>
        <source>{1} is not known here; it is kept</source>
        <translation>{=1} ist hier nicht bekannt; es bleibt erhalten</translation>
    </message>
    <message>
        <source>{1} is not known here; it is left out</source>
        <translation>{=1} ist hier nicht bekannt; es wird weggelassen</translation>
    </message>
    <message>
        <source>{1} is {2} × {3} pixels and {4} {5} × {6}; give two pictures of one size.</source>
        <translation>{=1} hat {2} × {3} Pixel und {=4} {5} × {6}; geben Sie zwei Bilder gleicher Größe an.</translation>
    </message>
    <message>
        <source>{1} is {2}; give a positive number</source>
        <translation>{1}: Der Wert ist {2}; geben Sie eine positive Zahl an</translation>
    </message>
    <message>
        <source>{1} LPI</source>
        <translation>{1} LPI</translation>
    </message>
    <message>
        <source>{1} LPI  {2} X {3} DPI</source>
        <translation>{1} LPI  {2} X {3} DPI</translation>
    </message>
    <message>
        <source>{1} LPI at {2} dpi leaves no more than one pixel for a lens; choose a finer printer or a coarser sheet</source>
        <translation>{1} LPI bei {2} dpi lassen nicht mehr als ein Pixel pro Linse; wählen Sie einen feineren Drucker oder eine gröbere Folie</translation>
    </message>
    <message>
        <source>{1} ms</source>
        <translation>{1} ms</translation>
    </message>
    <message>
        <source>{1} must be above 0</source>
        <translation>{=1} muss über 0 liegen</translation>
    </message>
    <message>
        <source>{1} must be an object: { ... }</source>
        <translation>{=1} muss ein Objekt sein: { ... }</translation>
    </message>
    <message>
        <source>{1} names nothing: there are {2}</source>
        <translation>{1} nennt nichts: Es gibt {2}</translation>
    </message>
    <message>
        <source>{1} needs &quot;children&quot;: an array of the nodes that it combines</source>
        <translation>{=1} braucht „children“: ein Array der Knoten, die es verbindet</translation>
    </message>
    <message>
        <source>{1} needs a &quot;child&quot;: the node that it changes</source>
        <translation>{=1} braucht ein „child“: den Knoten, den es ändert</translation>
    </message>
    <message>
        <source>{1} needs a &quot;{2}</source>
        <translation>{=1} braucht „{=2}</translation>
    </message>
    <message>
        <source>{1} needs a &quot;{2}&quot;: the name of a picture</source>
        <translation>{=1} braucht „{=2}“: den Namen eines Bildes</translation>
    </message>
    <message>
        <source>{1} needs a &quot;{2}&quot;: {3}</source>
        <translation>{=1} braucht „{=2}“: {3}</translation>
    </message>
    <message>
        <source>{1} needs a value behind it; `{2} --help` says which.</source>
        <translation>{=1} braucht dahinter einen Wert; `{=2} --help` sagt, welchen.</translation>
    </message>
    <message>
        <source>{1} needs two &quot;children&quot;: an array of the nodes that it combines</source>
        <translation>{=1} braucht zwei „children“: ein Array der Knoten, die es verbindet</translation>
    </message>
    <message>
        <source>{1} Nothing was chosen; allow more, or study other parameters.</source>
        <translation>{1} Nichts wurde gewählt; erlauben Sie mehr, oder untersuchen Sie andere Parameter.</translation>
    </message>
    <message>
        <source>{1} of the light of white</source>
        <translation>{1} des Lichts von Weiß</translation>
    </message>
    <message>
        <source>{1} of {2}</source>
        <translation>{=1} von {=2}</translation>
    </message>
    <message>
        <source>{1} of {2}: {3}</source>
        <translation>{1} von {2}: {3}</translation>
    </message>
    <message>
        <source>{1} of {2}: {3}.</source>
        <translation>{1} von {2}: {3}.</translation>
    </message>
    <message>
        <source>{1} offers no comparison &quot;{2}&quot;; choose one of {3}.</source>
        <translation>{=1} bietet keinen Vergleich „{=2}“; wählen Sie einen von {=3}.</translation>
    </message>
    <message>
        <source>{1} offers no comparisons; name two settings.</source>
        <translation>{=1} bietet keine Vergleiche; nennen Sie zwei Einstellungen.</translation>
    </message>
    <message>
        <source>{1} or {2}</source>
        <translation>{1} oder {2}</translation>
    </message>
    <message>
        <source>{1} other than {2}</source>
        <translation>{1} anders als {2}</translation>
    </message>
    <message>
        <source>{1} places had no outward side and were given one</source>
        <translation>{1} Stellen hatten keine Außenseite und bekamen eine</translation>
    </message>
    <message>
        <source>{1} samples were not finite numbers and were replaced.</source>
        <translation>{1} Samples waren keine endlichen Zahlen und wurden ersetzt.</translation>
    </message>
    <message>
        <source>{1} Take it out.</source>
        <translation>{1} Nehmen Sie sie heraus.</translation>
    </message>
    <message>
        <source>{1} takes no value; leave out what stands behind it.</source>
        <translation>{=1} nimmt keinen Wert; lassen Sie weg, was dahinter steht.</translation>
    </message>
    <message>
        <source>{1} thickness raised to {2} mm, as deep as its lenses are</source>
        <translation>{1} Dicke auf {2} mm erhöht, so tief, wie ihre Linsen sind</translation>
    </message>
    <message>
        <source>{1} This shape is left out.</source>
        <translation>{1} Diese Form wird weggelassen.</translation>
    </message>
    <message>
        <source>{1} times the work takes {2} times as long by this clock</source>
        <translation>das {1}-fache der Arbeit dauert nach dieser Uhr {2}-mal so lange</translation>
    </message>
    <message>
        <source>{1} to {2}</source>
        <translation>{1} bis {2}</translation>
    </message>
    <message>
        <source>{1} triangles without area were left out</source>
        <translation>{1} Dreiecke ohne Fläche wurden weggelassen</translation>
    </message>
    <message>
        <source>{1} uses the buffer &quot;{2}&quot;, which the plan does not declare</source>
        <translation>{=1} benutzt den Puffer „{=2}“, den der Plan nicht deklariert</translation>
    </message>
    <message>
        <source>{1} uses the image &quot;{2}&quot;, which the plan does not declare</source>
        <translation>{=1} benutzt das Bild „{=2}“, das der Plan nicht deklariert</translation>
    </message>
    <message>
        <source>{1} VIEWS</source>
        <translation>{1} VIEWS</translation>
    </message>
    <message>
        <source>{1} views share {2} pixels per lens: no more than {3} of them can be told apart.</source>
        <translation>{1} Ansichten teilen sich {2} Pixel pro Linse: Nicht mehr als {3} davon lassen sich unterscheiden.</translation>
    </message>
    <message>
        <source>{1} was given more than once; give it once.</source>
        <translation>{=1} steht mehrmals da; geben Sie es einmal an.</translation>
    </message>
    <message>
        <source>{1} within {2}: {3}; error {4} at worst, {5}</source>
        <translation>{1} innerhalb von {2}: {3}; Fehler {4} im schlechtesten Fall, {5}</translation>
    </message>
    <message>
        <source>{1} within {2}: {3}; error {4} at worst, {5} ms a frame</source>
        <translation>{1} innerhalb von {2}: {3}; Fehler {4} im schlechtesten Fall, {5} ms pro Frame</translation>
    </message>
    <message>
        <source>{1}&quot;; did you mean {2}?</source>
        <translation>{=1}&quot;; meinten Sie {=2}?</translation>
    </message>
    <message>
        <source>{1}, files</source>
        <translation>{1}, Dateien</translation>
    </message>
    <message>
        <source>{1}, held</source>
        <translation>{1}, angehalten</translation>
    </message>
    <message>
        <source>{1}, line {2}, column {3}, {4}: {5}.</source>
        <translation>{=1}, Zeile {2}, Spalte {3}, {=4}: {5}.</translation>
    </message>
    <message>
        <source>{1}, line {2}, column {3}: {4}.</source>
        <translation>{=1}, Zeile {2}, Spalte {3}: {4}.</translation>
    </message>
    <message>
        <source>{1}, line {2}: {3}</source>
        <translation>{=1}, Zeile {2}: {3}</translation>
    </message>
    <message>
        <source>{1}, shipped</source>
        <translation>{1}, mitgeliefert</translation>
    </message>
    <message>
        <source>{1}: give a name that ends in {2}</source>
        <translation>{=1}: Geben Sie einen Namen an, der auf {2} endet</translation>
    </message>
    <message>
        <source>{1}: give {2}</source>
        <translation>{=1}: Geben Sie an: {2}</translation>
    </message>
    <message>
        <source>{1}: here are no parts; make them with --shard 1/N to N/N and the same --out.</source>
        <translation>{=1}: Hier sind keine Teile; erzeugen Sie sie mit --shard 1/N bis N/N und demselben --out.</translation>
    </message>
    <message>
        <source>{1}: it is a preset of &quot;{2}&quot;, which is not in this museum.</source>
        <translation>{=1}: Das ist ein Preset von „{=2}“, das es in diesem Museum nicht gibt.</translation>
    </message>
    <message>
        <source>{1}: its animated parameters do not trigger new frames</source>
        <translation>{1}: Die animierten Parameter lösen keine neuen Frames aus</translation>
    </message>
    <message>
        <source>{1}: nothing was merged, because part {2} was drawn by {3} and part {4} by {5}; make all on machines of one kind.</source>
        <translation>{=1}: Nichts wurde zusammengefügt, weil Teil {=2} von {=3} und Teil {=4} von {=5} gezeichnet wurde; erzeugen Sie alle auf gleichartigen Rechnern.</translation>
    </message>
    <message>
        <source>{1}: nothing was merged. Of {2} parts,{3}</source>
        <translation>{=1}: Nichts wurde zusammengefügt. Von {=2} Teilen:{3}</translation>
    </message>
    <message>
        <source>{1}: the chart could not be drawn; check that Qt's offscreen platform and a font are installed.</source>
        <translation>{=1}: Das Diagramm konnte nicht gezeichnet werden; prüfen Sie, ob Qts Offscreen-Plattform und eine Schrift installiert sind.</translation>
    </message>
    <message>
        <source>{1}: the folder cannot be made ({2}); choose another with --out.</source>
        <translation>{=1}: Der Ordner lässt sich nicht anlegen ({=2}); wählen Sie mit --out einen anderen.</translation>
    </message>
    <message>
        <source>{1}: the folder cannot be made ({2}); choose another.</source>
        <translation>{=1}: Der Ordner lässt sich nicht anlegen ({2}); wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>{1}: the folder cannot be put in place ({2}); choose another with --out.</source>
        <translation>{=1}: Der Ordner lässt sich nicht an seinen Platz bringen ({=2}); wählen Sie mit --out einen anderen.</translation>
    </message>
    <message>
        <source>{1}: the parts are of another version of the program ({2}); merge them with that one.</source>
        <translation>{=1}: Die Teile stammen von einer anderen Version des Programms ({=2}); fügen Sie sie mit dieser zusammen.</translation>
    </message>
    <message>
        <source>{1}: there is no exhibit &quot;{2} `vitrine list` names them.</source>
        <translation>{=1}: Kein Exponat heißt &quot;{2} `vitrine list` nennt alle.</translation>
    </message>
    <message>
        <source>{1}: this format holds no 16 bits; give a name that ends in {2}, or leave --sixteen-bit out.</source>
        <translation>{=1}: Dieses Format hält keine 16 Bit; geben Sie einen Namen an, der auf {2} endet, oder lassen Sie --sixteen-bit weg.</translation>
    </message>
    <message>
        <source>{1}: this frame is missing or of other settings; draw it anew.</source>
        <translation>{=1}: Dieser Frame fehlt oder hat andere Einstellungen; zeichnen Sie ihn neu.</translation>
    </message>
    <message>
        <source>{1}: this is a picture of {2}; its settings were taken, and not its size, samples, time or turns.</source>
        <translation>{=1}: Dies ist ein Bild von {=2}; seine Einstellungen wurden übernommen, nicht aber Größe, Samples, Zeit und Drehungen.</translation>
    </message>
    <message>
        <source>{1}: this is damaged; make its part again.</source>
        <translation>{=1}: Dies ist beschädigt; erzeugen Sie den Teil neu.</translation>
    </message>
    <message>
        <source>{1}: this picture carries no preset; choose a preset file, or a picture that Vitrine made.</source>
        <translation>{=1}: In diesem Bild steht kein Preset; wählen Sie eine Preset-Datei oder ein Bild, das Vitrine gemacht hat.</translation>
    </message>
    <message>
        <source>{1}: this picture carries no preset; give a preset file, or a picture that Vitrine made.</source>
        <translation>{=1}: In diesem Bild steckt kein Preset; geben Sie eine Preset-Datei an, oder ein Bild, das Vitrine erzeugt hat.</translation>
    </message>
    <message>
        <source>{1}: this picture is transparent; give --transparent for a recording that is, too.</source>
        <translation>{=1}: Dieses Bild ist durchsichtig; geben Sie --transparent an, damit es auch die Aufnahme ist.</translation>
    </message>
    <message>
        <source>{1}: {2} has no parameter of that name{3} `vitrine list --json` names them.</source>
        <translation>{=1}: {=2} hat keinen Parameter dieses Namens{3} `vitrine list --json` nennt alle.</translation>
    </message>
    <message>
        <source>{1}: {2}; remove the folder, or give another --out.</source>
        <translation>{=1}: {2}; entfernen Sie den Ordner, oder geben Sie ein anderes --out an.</translation>
    </message>
    <message>
        <source>{1}; allow writing in that folder, or start Vitrine with XDG_DATA_HOME set to a folder that can be written.</source>
        <translation>{1}; erlauben Sie das Schreiben in diesem Ordner, oder starten Sie Vitrine mit XDG_DATA_HOME auf einem Ordner, in den geschrieben werden kann.</translation>
    </message>
    <message>
        <source>{1}; allow writing in that folder, or start Vitrine with XDG_STATE_HOME set to a folder that can be written. Until then nothing is saved there.</source>
        <translation>{1}; erlauben Sie das Schreiben in diesem Ordner, oder starten Sie Vitrine mit XDG_STATE_HOME auf einem Ordner, in den geschrieben werden kann. Bis dahin wird dort nichts gesichert.</translation>
    </message>
    <message>
        <source>{1}; allow writing in that folder.</source>
        <translation>{1}; erlauben Sie das Schreiben in diesem Ordner.</translation>
    </message>
    <message>
        <source>{1}; check the name and your permissions.</source>
        <translation>{1}; prüfen Sie den Namen und Ihre Rechte.</translation>
    </message>
    <message>
        <source>{1}; choose another folder or free some space.</source>
        <translation>{1}; wählen Sie einen anderen Ordner, oder geben Sie Platz frei.</translation>
    </message>
    <message>
        <source>{1}; correct it there.</source>
        <translation>{1}; korrigieren Sie es dort.</translation>
    </message>
    <message>
        <source>{1}; did you mean &quot;{2}&quot;? Known are {3}</source>
        <translation>{1}; meinten Sie „{=2}“? Bekannt sind {3}</translation>
    </message>
    <message>
        <source>{1}; did you mean {2}?</source>
        <translation>{=1}; meinten Sie {=2}?</translation>
    </message>
    <message>
        <source>{1}; export the file again.</source>
        <translation>{1}; exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>{1}; name the file itself.</source>
        <translation>{1}; nennen Sie die Datei selbst.</translation>
    </message>
    <message>
        <source>{1}; the old content is untouched; free some space or choose another disk</source>
        <translation>{1}; der alte Inhalt ist unberührt; geben Sie Platz frei, oder wählen Sie einen anderen Datenträger</translation>
    </message>
    <message>
        <source>{1}= is given twice; remove one of them.</source>
        <translation>{=1}= steht zweimal da; entfernen Sie eines davon.</translation>
    </message>
    <message>
        <source>{1}={2}: give a number from {3} to {4}</source>
        <translation>{=1}={=2}: gültig ist eine Zahl von {=3} bis {=4}</translation>
    </message>
    <message>
        <source>{1}={2}: give a whole number from {3} to {4}</source>
        <translation>{=1}={=2}: gültig ist eine ganze Zahl von {=3} bis {=4}</translation>
    </message>
    <message>
        <source>{1}` cannot be run as it was typed; `{2} --help` says what it takes.</source>
        <translation>{=1}` lässt sich so nicht ausführen; `{=2} --help` sagt, was es nimmt.</translation>
    </message>
    <message>
        <source>{1}` has no command &quot;{2} `{3} --help` lists what it has.</source>
        <translation>{=1}` kennt keinen Befehl &quot;{2} `{=3} --help` nennt alle.</translation>
    </message>
    <message>
        <source>{1}` has no option {2} `{3} --help` lists what it has.</source>
        <translation>{=1}` kennt keine Option {2} `{=3} --help` nennt alle.</translation>
    </message>
    <message>
        <source>{1}` needs --out; `{2} --help` says what it is.</source>
        <translation>{=1}` braucht --out; `{=2} --help` sagt, was das ist.</translation>
    </message>
    <message>
        <source>{1}` needs a command; `{2} --help` lists what it has.</source>
        <translation>{=1}` braucht einen Befehl; `{=2} --help` nennt alle.</translation>
    </message>
    <message>
        <source>{1}` needs {2}; `{3} --help` says what it is.</source>
        <translation>{=1}` braucht {=2}; `{=3} --help` sagt, was das ist.</translation>
    </message>
    <message>
        <source>{1}` takes no further argument, and &quot;{2}&quot; is one; `{3} --help` says what it takes.</source>
        <translation>{=1}` nimmt kein weiteres Argument, und &quot;{=2}&quot; ist eines; `{=3} --help` sagt, was es nimmt.</translation>
    </message>
    <message>
        <source>{1}direction {2}</source>
        <translation>{=1}direction {=2}</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>“%1” is already shown: both sides are the same.</source>
        <translation>„%1“ wird bereits gezeigt: Beide Seiten sind gleich.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>„%1“: %2</translation>
    </message>
    <message>
        <source>“{1}” is above {2}</source>
        <translation>„{1}“ über {2} liegt</translation>
    </message>
    <message>
        <source>“{1}” is not {2}</source>
        <translation>„{1}“ nicht auf {2} steht</translation>
    </message>
    <message>
        <source>“{1}” is {2}</source>
        <translation>„{1}“ auf {2} steht</translation>
    </message>
    <message>
        <source>“{1}” names a file</source>
        <translation>„{1}“ eine Datei nennt</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>◂ Back</source>
        <translation>◂ Zurück</translation>
    </message>
    <message>
        <source>✕ Leave</source>
        <translation>✕ Verlassen</translation>
    </message>
</context>
</TS>
