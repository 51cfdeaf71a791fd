# What the command line shows beside alarms.

label-machine = tezgâh
label-control = kontrol
label-guessed = { $dialect } (belirtilmedi; --dialect başkasını seçer)
label-guessed-content = { $dialect } ({ $blocks } bloktan { $unread } tanesi { $other } değil; --dialect başkasını seçer)
label-guessed-extension = { $dialect } (dosya uzantısına göre; --dialect başkasını seçer)
label-built-in = { $machine } (yerleşik; --machine başkasını belirtir)
label-time = süre
label-cutting = kesme
label-rapid = hızlı
label-dwell = bekleme
label-tool-changes = takım değişimleri
label-spindle = iş mili
label-distance = yol
label-extents = kapsam
label-moves = hareketler
label-parts = parçalar
label-tool = T{ $tool }
label-by-tool = takımlara göre
label-no-moves = hareket yok
label-no-tool = takım yok
label-stopped = { $code } durdurdu; çevrim başlatma ile sürer
label-press-enter = çevrim başlatma için Enter'a basın
label-ended-by-alarm = bir alarm durdurdu; o ana kadar yapılan:
label-written = yazıldı: { $file }
label-checked = { $machine } üzerinde { $files ->
    [one] 1 dosya
   *[other] { $files } dosya
} denetlendi: { $findings ->
    [0] bulgu yok
    [one] 1 bulgu
   *[other] { $findings } bulgu
}
label-further = { $count } bulgu daha
label-times = program buraya { $count } kez geldi

## Explanations

label-error = hata: { $text }
label-near = { $text }; benzerleri: { $names }
label-unknown = { $name }, { $dialect } kontrolünün bildiği bir şey değil
label-no-code = { $dialect } kontrolünde { $name } kodu yok
label-no-alarm = { $dialect } kontrolünde { $name } alarmı yok
label-no-variable = { $dialect } kontrolünde #{ $name } değişkeni yok
label-no-parameter = { $dialect } kontrolünde { $name } parametresi yok
label-no-parameters = { $dialect } kontrolünün parametreleri yok
label-no-sign = { $dialect } aritmetik parametrelerini işaretsiz yazar: { $name }
label-several-parameters = { $name } birden çok parametrenin simgesi: { $names }
label-whole-bits = { $name } birden çok bitten oluşur: birini belirtin, örneğin { $name }.1
label-malformed-name = { $name } bir parametre adı değil: P270, NO43.1 ya da simgeyi yazın
label-out-of-range = { $name }, { $value } olamaz; olması gereken: { $range }
label-any-number = bir sayı
label-not-a-bit = { $name }, { $value } olamaz: bir bittir, 0 ya da 1
label-not-whole = { $name }, { $value } olamaz: bir tam sayıdır
label-value-changed = { $value } (varsayılan { $default })
label-explain-form = yazım
label-explain-group = grup
label-explain-modal = modal
label-explain-one-block = yalnız kendi bloğunda
label-explain-modal-depends = modal olup olmadığı parametrelere ve biçime bağlı
label-explain-at-power-on = açılışta etkin
label-explain-replaces = gruptakiler
label-explain-does = işlevi
label-explain-section = kılavuz
label-explain-note = not
label-explain-not-done = bu sürüm yürütmüyor
label-explain-forms = biçimler
label-explain-parameters = parametreler
label-explain-alarms = alarmlar
label-explain-codes = kodlar
label-explain-no-meaning = kılavuz anlamını vermeden anar; anlamını tezgâh üreticisi belirler
label-explain-timing = ne zaman
label-explain-with-motion = bloğundaki hareketle birlikte başlar
label-explain-after-motion = bloğundaki hareketten sonra
label-explain-class = yürüten
label-explain-program-control = kontrol, program komutu olarak
label-explain-internal = kontrol
label-explain-plc = tezgâhın merdiven programı
label-explain-alone = blok
label-explain-own-block = bloğunda bu türden başka kod olamaz
label-explain-meaning = anlamı
label-explain-one = 1
label-explain-zero = 0
label-explain-value = değer
label-explain-default = varsayılan
label-explain-range = aralık
label-explain-bit = 0 ya da 1
label-explain-no-range = kılavuzda yazmıyor
label-explain-whole = tam sayılar
label-explain-axis = eksen
label-explain-room = bölüm
label-explain-other-room = { $room }; değeriyle saklanır, bu sürüm kullanmaz
label-explain-help = ne yapmalı
label-explain-source = kaynağı
label-explain-raised_by = nedeni
label-explain-shown_as = gösterilişi
label-explain-numbers = numaralar
label-explain-access = erişim
label-explain-read = salt okunur
label-explain-write = yalnız yazılır
label-explain-read-write = okunur ve yazılır
label-explain-access-unknown = kılavuz belirtmiyor
label-explain-this_one = bu değişken
label-explain-external = harici ofset
label-explain-notes = notlar
label-explain-part_of = ait olduğu
label-explain-no-variable = kılavuzda açıklanmamış; programlar kullanamaz
label-explain-place = yer
label-explain-used_by = okuyan
label-explain-in_force = etkin
label-explain-no-block = { $file }, satır { $line }: blok yok
label-explain-no-word = { $file }, satır { $line }, sütun { $column }: sözcük yok
label-explain-no-word-there = { $file }, satır { $line }, sütun { $column }: sözcük yok; satırın sözcükleri ve sütunları: { $words }
label-explain-comment = { $file }, satır { $line }, sütun { $column }: bir açıklama
label-explain-no-line = { $file } bir dosya: bir satırını, { $file }:12, ya da satır ve sütununu, { $file }:12:5, yazın
label-explain-drawing = { $file } bir { $kind } çizimi, içinde program sözcüğü yok: "ferrocut import" ondan program yapar
label-room-acceleration = ivmelenme
label-room-bus-servo = servo sürücüler ve veri yolu
label-room-canned-cycles = sabit çevrimler
label-room-compensation = telafi
label-room-coordinates = koordinatlar
label-room-display = görüntüleme
label-room-feed = ilerleme
label-room-homing = referans noktaları
label-room-io = girişler ve çıkışlar
label-room-limits = sınırlar
label-room-lookahead = ileriye bakma
label-room-macro = makrolar
label-room-other = diğer
label-room-plc = merdiven programı
label-room-program-edit = program düzenleme
label-room-security = yetkiler
label-room-spindle = iş mili
label-room-tapping = kılavuz çekme
label-room-tool-change = takım değişimi
label-room-tool-life = takım ömrü
label-class-program = parça programı
label-class-macro = bir makro deyimi
label-class-operation = panelin kullanımı
label-class-homing = referans noktaları
label-class-storage = program belleği
label-class-servo = bir eksen sürücüsü
label-class-spindle = iş mili
label-class-overtravel = sınırını aşmış bir eksen
label-class-plc = merdiven programı
label-class-system = kontrolün kendisi

## Machine files and parameters

label-warning = uyarı: { $text }
label-exists = { $file } zaten var, değiştirilmedi
label-nothing-written = hiçbir şey yazılmadı
label-no-assignment = { $text } bir değer vermiyor: AD=DEĞER yazın
label-no-number = { $name }, { $value } olamaz: bu bir sayı değil
label-set-twice = { $name } iki kez verilmiş
label-named-twice = { $name } ile { $other } aynı parametre
label-lower-above-upper = { $first }, öbür sınırı olan { $second } değerinden küçük olmalı
label-same-axis = { $first } ve { $second } aynı ekseni adlandırıyor; kontrol X, Y, Z, A alırdı
label-both-bits = { $first } ve { $second } ikisi birden 1 olamaz
label-passed-over = { $file }: { $reason }; atlandı
label-no-room = { $name } bölümü yok; bölümler: { $names }
label-no-column = { $file } dosyasında { $name } sütunu yok
label-no-row = { $file }, satır { $line }: bir tablo satırı değil
label-row-twice = { $name } zaten { $line }. satırda var
label-imported = { $changed ->
    [0] hiçbir değer değişmedi
    [one] 1 değer değişti
   *[other] { $changed } değer değişti
}, { $same } değer aynı kaldı
label-params-name = ad
label-params-symbol = simge
label-params-value = değer
label-params-default = varsayılan
label-params-range = aralık
label-params-unit = birim
label-params-room = bölüm
label-params-use = kullanım
label-params-kept = saklanır
label-params-used = kullanılır
label-params-meaning = anlamı
label-params-unchanged = bu parametrelerin hiçbiri varsayılan değerinden farklı değil
label-params-no-match = { $dialect } kontrolünde { $name } ile eşleşen parametre yok
label-params-checked = { $file } dosyasının { $parameters ->
    [one] 1 parametresi
   *[other] { $parameters } parametresi
} denetlendi: { $findings ->
    [0] bulgu yok
    [one] 1 bulgu
   *[other] { $findings } bulgu
}
label-machine-axis = eksen
label-machine-kind = tür
label-machine-linear = doğrusal
label-machine-rotary = döner
label-machine-limits = sınırlar
label-machine-rapid = hızlı
label-machine-cutting = kesme
label-machine-acceleration = ivme
label-machine-jerk = jerk
label-machine-unlimited = sınırsız
label-machine-control = kontrol
label-machine-period = servo periyodu
label-machine-spindle-name = iş mili
label-machine-tool-change-name = takım değişimi
label-machine-tools = { $tools ->
    [one] 1 takım
   *[other] { $tools } takım
}
label-machine-tolerance-name = tolerans
label-machine-exact-stop = her blok geçişinde tam duruş
label-machine-parameters = parametreler
label-machine-dialect = { $name } adlı bir program dili yok
label-machine-no-axis = { $dialect } programları { $axis } eksenini adlandıramaz
label-machine-travel = eksen { $axis }: { $value } mm kurs her tezgâhınkinden uzun; max mm olarak mı?
label-machine-zero = eksen { $axis }: tezgâh konumu 0, min ve max dışında; kurulum başlangıç belirtmezse programlar orada başlar
label-machine-fast = eksen { $axis }: { $value } mm/dk hızlı hareket hiçbir tezgâhta olmaz; bunlar mm/dk mı?
label-machine-velocity = eksen { $axis }: { $value } mm/dk kesme ilerlemesi hızlı hareketten yüksek
label-machine-sluggish = eksen { $axis }: hızlı hareket hızına { $value } s içinde ulaşıyor; acceleration m/s² değil, mm/s² olarak mı?
label-machine-abrupt = eksen { $axis }: { $value } ivmeyle hızlı hareket hızına { $limit } s dolmadan ulaşılıyor; mm/s² olarak mı?
label-machine-jerk-low = eksen { $axis }: bu jerk değeriyle ivmenin oluşması { $value } s sürüyor; jerk mm/s³ olarak mı? 0 sınırsızdır
label-machine-smoothing-differs = eksen { $axis }: after_cutting öbür eksenlerinkinden farklı; hızın değiştiği yerde doğrular eğilir
label-machine-pitch-off = eksen { $axis }: pitch_errors var, start ve interval yok; kontrolün hiçbir parametresi noktaların yerini söylemiyor; telafi yapılmaz
label-machine-spindle = iş milinin { $value } dev/dk hızı hiçbir tezgâhta olmaz
label-machine-spindle-sluggish = iş mili en yüksek devrine { $value } s içinde ulaşıyor; acceleration_rpm_s saniyede dev/dk olarak mı?
label-machine-tolerance = { $value } mm sapabilen bir yolla parça kesilmez; tolerance mm olarak mı?
label-machine-tool-change = takım değişimi { $value } s sürüyor; time_s saniye olarak mı?
label-machine-file-missing = burada { $file } adı geçiyor, ama makine dosyasının yanında okunamıyor: { $reason }
label-public-missing = public_programs { $file } dosyasını gösteriyor, ama okunamıyor ({ $reason }); her kod oradaki bir program olabilir: dosyayı oraya koyun, --public ile başkasını verin ya da satırı çıkarın
label-linuxcnc-file = rs274 programları içindir, oysa verilen dil { $dialect }: ikisinden birini çıkarın
label-quote-bits = Bit parametrelerinin adları tırnak içinde yazılır: "NO43.1" = 1

## Drawings

label-drawing-by-name = { $file }: { $kind } çizimi olarak okundu (adına göre)
label-drawing-by-content = { $file }: { $kind } çizimi olarak okundu (içeriğine göre)
label-stage-read = çizim okunuyor
label-stage-plan = sıra planlanıyor
label-stage-write = program yazılıyor
label-stage-prove = program sınanıyor
label-drawing-made = { $file }: { $kind }, { $wide } x { $high } mm, toplam { $cut } mm uzunlukta { $curves } kesim, { $ways } inme, havada { $way } mm

## Plots

label-plot-title = { $program }, { $machine }
label-plot-note = Farklar { $period } ms servo periyoduna göredir; jerk { $window } ms ortalamasıdır. Kesikli: izin verilen.
label-plot-speed = yol boyunca hız ve programlanan ilerleme (kesikli), mm/dk
label-plot-velocity = hız { $axis }, { $length }/dk; kesme ve konumlama sınırları
label-plot-acceleration = ivme { $axis }, { $length }/s²
label-plot-jerk = jerk { $axis }, { $length }/s³
label-plot-error = yol hatası ve tolerans (kesikli), mm
label-plot-peak = en yüksek { $value }, { $time } s, satır { $line }
label-plot-time = hareketin başlangıcından beri geçen süre, s

## Pictures of paths

label-view-top = ÜSTTEN
label-view-isometric = İZOMETRİK
label-view-start = başlangıç
label-view-end = bitiş
label-view-zero = iş sıfırı
label-view-rapid = hızlı hareket
label-view-cut = kesme
label-view-depths = kesme, sığdan derine
label-view-nothing = hareket yok
label-view-no-axes = X, Y veya Z hareketi yok
label-view-depth = Z mm
label-view-length = { $length } mm
label-view-work = iş koordinatları, mm
label-view-machine = makine koordinatları, mm
label-view-moves = { $count ->
   *[other] { $shown } hareket
}
label-view-rapids = { $count ->
   *[other] { $shown } hızlı
}
label-view-cuts = { $length } mm boyunca { $shown } kesme
label-view-along = X, Y, Z boyunca { $length } mm
label-view-memory = resim için bellek yetersiz
label-view-encoding = resim PNG olarak yazılamıyor: { $reason }

## Restart

label-restart-at = { $line }. satırdan sürdürülüyor, { $pass }. varışta
label-restart-position = bloğun başladığı yer
label-restart-modal = program / tezgâhta önceki
label-restart-sent = önce gönderilen
label-restart-approach = eksenlerin gideceği yer
label-restart-nothing = hiçbir şey
label-restart-group = G grubu { $group }
label-restart-feed = F
label-restart-feed-per-turn = devir başına F
label-restart-speed = S
label-restart-spindle = iş mili
label-restart-flood = soğutma sıvısı
label-restart-mist = sis
label-restart-tool = T
label-restart-in-spindle = iş milindeki takım
label-restart-length = H
label-restart-radius = D
label-restart-zero = { $axis } sıfırı
label-restart-tool-length = { $axis } takım boyu

## Machine and set-up files

label-unknown-parameter = { $name }: kontrolde böyle bir parametre yok
label-too-many-parameters = çok fazla parametre: hiçbir kontrolde { $max } taneden fazlası yok
label-config-positive = { $what } { $value }: 0'dan büyük olmalı
label-config-not-negative = { $what } { $value }: 0 ya da daha büyük olmalı
label-config-range = { $what } { $value }: { $min } ile { $max } arasında olmalı
label-config-count = { $what }: { $value } tane var, { $min } ile { $max } arasında olabilir
label-config-twice = { $what } iki kez geçiyor
label-config-finite = { $what } { $value }: sonlu bir sayı olmalı
label-config-no-machine = bu bir makine dosyası değil: içinde axes yok; "ferrocut machine new" başlangıç için bir tane yazar
label-config-order = { $what }: min { $min }, max { $max } değerinden küçük olmalı
label-config-unequal = { $what }: { $value } tane var, { $other } ise { $count } tane: sayıları eşit olmalı
label-config-either = { $what }: ya { $one } ya da { $other } gerekir
label-config-no-axis = { $what }: tezgâhta böyle bir eksen yok
label-config-step = { $what } { $value }: en az bir adım, { $min }, olmalı, çünkü eksen yerine komuttan sonra gelir
label-config-lag = { $what } { $value }: en yüksek hızında eksen, tamponda bekleyenler yüzünden { $min } geride kalır
label-config-parameter = [parameters] { $reason }: değiştirin ya da silin
label-config-null-variable = { $what }: #0 her zaman boştur ve verilemez; silin
label-config-variables = { $what }: bu kadar çok değişken için yer yok; bazılarını silin
label-config-work-offset = [work_offsets] { $name }: kontrolde G54 P1 - P{ $max } var; değiştirin ya da silin
label-config-tool = [tools.{ $number }]: kontrolde 1 ile { $max } arası ofset numaraları var; değiştirin ya da silin
label-config-no-place = { $name }: başka bir eksen için yer yok; u, v, w eksenlerinden birini silin
label-config-var-line = satır { $line }: oraya 1 ile { $max } arasında bir numara ve bir değer gelir
label-config-tool-word = satır { $line }: { $word }, takım tablosunun bir sözcüğü değil
label-config-no-tool = satır { $line }: hangi takım olduğunu söyleyen T sözcüğü yok
label-config-tool-twice = satır { $line }: T{ $tool } takımı iki kez geçiyor; birini silin
label-config-tools = satır { $line }: { $max } taneden fazla takım
